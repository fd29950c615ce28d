/** A file of the demonstration to try with, where one's own will go; nothing while there is none. */
import { say } from "../../core/messages";
import { useAsked } from "../../core/resource";
import { formatSmall } from "../../core/units";

type Kind = "pictures" | "clip" | "catalogue";

export function SampleLink({ kind }: { kind: Kind }) {
  const { data } = useAsked("GET /samples");
  if (!data) return null;
  const { pictures, clip } = data;
  if (kind === "pictures") {
    if (!pictures) return null;
    const square = formatSmall(pictures.square_m);
    return (
      <Link address="/api/samples/pictures.zip" words={say("samples-pictures", { ...pictures, square })} />
    );
  }
  if (kind === "clip") {
    return clip === null ? null : (
      <Link address={`/api/recordings/${clip}/video`} words={say("samples-clip")} />
    );
  }
  return <Link address="/api/samples/catalogue.csv" words={say("samples-catalogue")} />;
}

function Link({ address, words }: { address: string; words: string }) {
  return (
    <p class="small">
      <a href={address} download="">
        {words}
      </a>
    </p>
  );
}
