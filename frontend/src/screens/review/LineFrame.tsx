/** Both strips, with the two points of the reviewed height on camera 1. */
import { Loading } from "../../components";
import { say } from "../../core/messages";
import { StripsPicture } from "../../parts/strips/StripsPicture";
import type { LinePicture } from "./LinePicture";

export function LineFrame({ picture }: { picture: LinePicture }) {
  const strips = picture.strips.value;
  if (!strips) return <Loading what={say("scan-strips")} />;
  return (
    <StripsPicture
      stage={picture.stage}
      tiles={strips.tiles}
      draw={(canvas, view) => picture.draw(canvas, view)}
      fit={() => picture.stage.fit()}
    />
  );
}
