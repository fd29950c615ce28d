/** Both strips, with the two points of the reviewed height on camera 1. */
import { Loading } from "../../components";
import { say } from "../../core/messages";
import { OverStrips } from "../../parts/strips/OverStrips";
import { Picture } from "../../viewer/Picture";
import type { LinePicture } from "./LinePicture";

export function LineFrame({ picture }: { picture: LinePicture }) {
  const strips = picture.strips.value;
  if (!strips) return <Loading what={say("scan-strips")} />;
  return (
    <Picture
      stage={picture.stage}
      class="strips"
      testId="strips"
      what={say("scan-strips")}
      label={say("scan-strips-label")}
      panByDrag
      draw={(canvas, view) => picture.draw(canvas, view)}
      onDblClick={() => picture.stage.fit()}
      above={<OverStrips tiles={strips.tiles} />}
    />
  );
}
