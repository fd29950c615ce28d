/** The recording as a strip: thumbnails, spans (passes, the board), what is loaded, where we are. Click or drag to go. */
import { useSignal } from "@preact/signals";
import { useEffect, useMemo, useRef } from "preact/hooks";
import { say } from "../core/messages";
import { formatFrameTime } from "../core/times";
import type { Recording } from "../core/types";
import { nearestThumb } from "./ahead";
import type { Player } from "./player";
import { drawnSpans, type Span } from "./spans";
import { clamp } from "./view";

const THUMB_PX = 72;

export function Timeline({ player, spans }: { player: Player; spans: readonly Span[] }) {
  const host = useRef<HTMLDivElement>(null);
  const width = useSignal(800);
  const ghost = useSignal<number | null>(null);
  const recording = player.recording.value;
  const count = recording?.frame_count ?? 0;
  // the strip is drawn at every frame that is gone to; its bars change with the passes alone
  const drawn = useMemo(() => drawnSpans(spans, count, width.value), [spans, count, width.value]);

  useEffect(() => {
    const element = host.current;
    if (!element) return;
    const watcher = new ResizeObserver(() => {
      width.value = element.clientWidth;
    });
    watcher.observe(element);
    return () => watcher.disconnect();
  }, []);

  const frameAt = (event: PointerEvent): number => {
    const box = host.current?.getBoundingClientRect();
    if (!box || count < 1) return 0;
    const share = (event.clientX - box.left) / box.width;
    return clamp(Math.floor(share * count), 0, count - 1);
  };
  const move = (event: PointerEvent): void => {
    ghost.value = frameAt(event);
    if (event.buttons & 1) player.go(frameAt(event));
  };
  const down = (event: PointerEvent): void => {
    if (event.button !== 0) return;
    host.current?.setPointerCapture(event.pointerId);
    player.stop();
    player.go(frameAt(event));
  };
  const place = (frame: number): string => `${count > 0 ? (100 * frame) / count : 0}%`;

  return (
    <div
      ref={host}
      class="timeline"
      role="slider"
      tabIndex={0}
      aria-label={say("timeline-label")}
      aria-valuemin={0}
      aria-valuemax={Math.max(0, count - 1)}
      aria-valuenow={player.frame.value}
      aria-valuetext={describe(player, player.frame.value)}
      data-testid="timeline"
      onPointerDown={down}
      onPointerMove={move}
      onPointerLeave={() => {
        ghost.value = null;
      }}
    >
      {recording && <Thumbs recording={recording} count={Math.max(1, Math.ceil(width.value / THUMB_PX))} />}
      <div class="timeline__spans">
        {drawn.map((span) => (
          <div
            key={span.id}
            class={`timeline__span timeline__span--${span.kind}`}
            title={span.title}
            style={{ left: place(span.first), width: place(span.last - span.first + 1) }}
          >
            {span.label}
          </div>
        ))}
      </div>
      {player.ready.value.map(([first, last]) => (
        <div
          class="timeline__ready"
          title={say("timeline-decoded")}
          style={{ left: place(first), width: place(last - first + 1) }}
        />
      ))}
      {player.ranges.value.map(([first, last]) => (
        <div class="timeline__loaded" style={{ left: place(first), width: place(last - first + 1) }} />
      ))}
      <div class="timeline__needle" style={{ left: place(player.frame.value + 0.5) }} />
      {ghost.value !== null && (
        <div
          class="timeline__ghost"
          style={{ left: `clamp(70px, ${place(ghost.value)}, calc(100% - 70px))` }}
        >
          {describe(player, ghost.value)}
        </div>
      )}
    </div>
  );
}

function describe(player: Player, index: number): string {
  const time = player.timeOf(index);
  const frame = String(index);
  return time === null
    ? say("viewer-frame", { frame })
    : say("viewer-frame-at", { frame, time: formatFrameTime(time) });
}

function Thumbs({ recording, count }: { recording: Recording; count: number }) {
  const frames = recording.frame_count ?? 0;
  const thumbs = recording.thumbs;
  if (thumbs.length === 0 || frames === 0) return null;
  const chosen = Array.from({ length: count }, (_, i) => nearestThumb(thumbs, ((i + 0.5) / count) * frames));
  return (
    <div class="timeline__thumbs">
      {chosen.map((thumb, i) => (
        <img key={i} src={thumb?.url} alt="" loading="lazy" draggable={false} />
      ))}
    </div>
  );
}
