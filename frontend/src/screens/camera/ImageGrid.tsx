import { IconButton, StateMark } from "../../components";
import { say, sentenceOf } from "../../core/messages";
import type { CalibrationImage } from "../../core/types";
import { STATE_WORDS } from "../../core/words";
import { CornerMarks } from "./CornerMarks";

/** Each image with what was found in it drawn over. */
export function ImageGrid({
  images,
  remove,
}: {
  images: CalibrationImage[];
  remove: (image: CalibrationImage) => void;
}) {
  return (
    <ul class="shots">
      {images.map((image) => (
        <li key={image.id} class="shot">
          <div class="shot__picture" style={{ aspectRatio: `${image.width_px} / ${image.height_px}` }}>
            <img src={image.url} alt={image.found ? "" : image.name} loading="lazy" />
            {image.found && (
              <CornerMarks
                width={image.width_px}
                height={image.height_px}
                corners={image.corners_px}
                columns={image.columns}
                ids={image.ids}
                label={say("camera-corners-found", { count: image.corners_px.length, image: image.name })}
              />
            )}
          </div>
          <div class="shot__words">
            <span class="clip" title={image.name}>
              {image.name}
            </span>
            <IconButton
              icon="close"
              label={say("camera-remove", { image: image.name })}
              onClick={() => remove(image)}
            />
          </div>
          <p class="shot__state">
            <StateMark
              state={image.found ? "used" : "left_out"}
              word={image.found ? foundInWords(image) : STATE_WORDS.left_out}
            />
          </p>
          {image.reason && <p class="small muted">{sentenceOf(image.reason)}</p>}
        </li>
      ))}
    </ul>
  );
}

function foundInWords({ ids, columns, rows }: CalibrationImage): string {
  return ids
    ? say("camera-found-some", { found: ids.length, all: columns * rows })
    : say("camera-found-all", { columns, rows });
}
