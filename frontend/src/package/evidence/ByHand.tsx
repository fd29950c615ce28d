/** Both pictures with boundaries that the reader sets, laid over each other, and what these boundaries give. */
import { useState } from "preact/hooks";
import { fixed } from "../digits";
import { Grid } from "../Section";
import { say } from "../say";
import { allSet, type Hand, plainOf, spanOf, speedOf } from "./byHand";
import type { Evidence, Held, Lines, PictureFacts } from "./document";

const KMH = 3.6;
const EDGES = ["front", "rear"] as const;
const CAMERAS = [1, 2] as const;
const MOST_ZOOM = 16;
const NONE = "–";

type Edge = (typeof EDGES)[number];
type Camera = (typeof CAMERAS)[number];
type Name = keyof Lines;

const nameOf = (edge: Edge, camera: Camera): Name => `${edge}_line_${camera}`;

/** Nothing is set beforehand: boundaries near those of the file would look like the reader's own. */
const NOTHING: Hand = { front_line_1: null, rear_line_1: null, front_line_2: null, rear_line_2: null };

export function ByHand({ file }: { file: Held }) {
  const { evidence, pictures } = file;
  const [hand, setHand] = useState(NOTHING);
  const [edge, setEdge] = useState<Edge>("front");
  const [zoom, setZoom] = useState(1);
  const [own, showOwn] = useState(false);
  const place = (name: Name, line: number) => setHand((before) => ({ ...before, [name]: line }));
  const addresses = evidence.pictures.map((one) => `data:image/png;base64,${pictures.get(one.name) ?? ""}`);
  return (
    <section class="opened__section" id="by-hand">
      <h2 class="opened__name">{say("opened-evidence-pictures")}</h2>
      <p>{say("opened-evidence-by-hand")}</p>
      <div class="opened__tools">
        {EDGES.map((one) => (
          <label key={one} class="opened__filter">
            <input type="radio" name="edge" checked={edge === one} onChange={() => setEdge(one)} />
            {say("opened-evidence-set", { edge: one })}
          </label>
        ))}
        <label class="opened__filter">
          {say("opened-evidence-zoom")}
          <input type="range" min={1} max={MOST_ZOOM} value={zoom} onInput={taken(setZoom)} />
        </label>
        <label class="opened__filter">
          <input type="checkbox" checked={own} onChange={() => showOwn(!own)} />
          {say("opened-evidence-show-lines")}
        </label>
      </div>
      {CAMERAS.map((camera) => (
        <Strip
          key={camera}
          camera={camera}
          picture={evidence.pictures[camera - 1] as PictureFacts}
          address={addresses[camera - 1] ?? ""}
          hand={hand}
          file={own ? evidence.measurement : null}
          zoom={zoom}
          place={(line) => place(nameOf(edge, camera), line)}
        />
      ))}
      <Table evidence={evidence} hand={hand} place={place} />
      <Overlay evidence={evidence} addresses={addresses} hand={hand} zoom={zoom} />
    </section>
  );
}

/** What is typed or slid; what is no number is not taken. */
function taken(set: (value: number) => void) {
  return ({ currentTarget: { valueAsNumber } }: { currentTarget: HTMLInputElement }) => {
    if (Number.isFinite(valueAsNumber)) set(valueAsNumber);
  };
}

interface StripProps {
  camera: Camera;
  picture: PictureFacts;
  address: string;
  hand: Hand;
  file: Lines | null;
  zoom: number;
  place: (line: number) => void;
}

function Strip({ camera, picture, address, hand, file, zoom, place }: StripProps) {
  const { start, width } = spanOf(picture);
  const at = (event: PointerEvent) => {
    const box = (event.currentTarget as SVGElement).getBoundingClientRect();
    const line = start + ((event.clientX - box.left) / box.width) * width;
    place(Math.round(Math.min(start + width, Math.max(start, line)) * 10) / 10);
  };
  return (
    <figure class="evidence__figure">
      <figcaption>{say("opened-evidence-camera", { camera })}</figcaption>
      <div class="evidence__window">
        <svg
          class="evidence__strip"
          data-camera={camera}
          style={{ width: `${100 * zoom}%` }}
          viewBox={`${start} 0 ${width} ${picture.rows_px}`}
          preserveAspectRatio="none"
          role="img"
          aria-label={say("opened-evidence-camera", { camera })}
          onPointerDown={at}
          onPointerMove={(event) => {
            if (event.buttons === 1) at(event);
          }}
        >
          <image
            href={address}
            x={start}
            y={0}
            width={width}
            height={picture.rows_px}
            preserveAspectRatio="none"
          />
          {EDGES.map((edge) => (
            <Mark key={edge} line={hand[nameOf(edge, camera)]} rows={picture.rows_px} kind={edge} />
          ))}
          {file &&
            EDGES.map((edge) => (
              <Mark key={edge} line={file[nameOf(edge, camera)]} rows={picture.rows_px} kind="file" />
            ))}
        </svg>
      </div>
    </figure>
  );
}

function Mark({ line, rows, kind }: { line: number | null; rows: number; kind: Edge | "file" }) {
  if (line === null) return null;
  return (
    <>
      <line class="evidence__halo" x1={line} x2={line} y1={0} y2={rows} />
      <line class={`evidence__mark evidence__mark--${kind}`} x1={line} x2={line} y1={0} y2={rows} />
    </>
  );
}

interface TableProps {
  evidence: Evidence;
  hand: Hand;
  place: (name: Name, line: number) => void;
}

function Table({ evidence, hand, place }: TableProps) {
  const m = evidence.measurement;
  const plain = plainOf(hand, evidence.at_vehicle.baseline_m, m.rig.line_rate_hz);
  const none = say(allSet(hand) ? "opened-evidence-no-speed" : "opened-evidence-not-set");
  return (
    <>
      <Grid
        class="evidence__compared"
        heads={[say("opened-evidence-quantity"), say("opened-evidence-hand"), say("opened-evidence-file")]}
      >
        {CAMERAS.flatMap((camera) => EDGES.map((edge) => [edge, camera] as const)).map(([edge, camera]) => {
          const name = nameOf(edge, camera);
          return (
            <tr key={name}>
              <th scope="row">{say("opened-evidence-line", { edge, camera })}</th>
              <td>
                <input
                  type="number"
                  class="evidence__line"
                  data-line={name}
                  step={1}
                  aria-label={say("opened-evidence-line", { edge, camera })}
                  value={hand[name] ?? ""}
                  onInput={taken((line) => place(name, line))}
                />
              </td>
              <td>{fixed(m[name], 1)}</td>
            </tr>
          );
        })}
        <tr>
          <th scope="row">{say("opened-evidence-plain-front")}</th>
          <td data-hand="front">{speedWords(plain?.front_mps ?? null, none)}</td>
          <td rowSpan={2}>{speedWords(m.speed_mps, NONE)}</td>
        </tr>
        <tr>
          <th scope="row">{say("opened-evidence-plain-rear")}</th>
          <td data-hand="rear">{speedWords(plain?.rear_mps ?? null, none)}</td>
        </tr>
        <tr>
          <th scope="row">{say("opened-evidence-length")}</th>
          <td data-hand="length">{lengthWords(plain?.length_m ?? null, none)}</td>
          <td>{lengthWords(m.length_m, NONE)}</td>
        </tr>
      </Grid>
      <p class="opened__quiet">{say("opened-evidence-plain")}</p>
    </>
  );
}

function speedWords(speed_mps: number | null, none: string): string {
  if (speed_mps === null) return none;
  return say("opened-evidence-speed-of", {
    kmh: fixed(KMH * speed_mps, 2),
    mps: fixed(speed_mps, 3),
  });
}

function lengthWords(length_m: number | null, none: string): string {
  return length_m === null ? none : `${fixed(length_m, 3)}\u00a0m`;
}

interface OverlayProps {
  evidence: Evidence;
  addresses: readonly string[];
  hand: Hand;
  zoom: number;
}

/** By how many lines, to a tenth, one end crosses camera 2 later than camera 1; null where that is not set. */
function shiftOf(lines: Hand, edge: Edge): number | null {
  const [first, second] = [lines[`${edge}_line_1`], lines[`${edge}_line_2`]];
  return first === null || second === null ? null : Math.round(10 * (second - first)) / 10;
}

/** Picture 2 moved back by a shift in lines and laid over picture 1. */
function Overlay({ evidence, addresses, hand, zoom }: OverlayProps) {
  const [one, two] = evidence.pictures as [PictureFacts, PictureFacts];
  const [first, second] = [spanOf(one), spanOf(two)];
  // camera 2's picture lies before camera 1's where the vehicle reached camera 2 first
  const apart = Math.round(second.start - first.start) || 1;
  const [shift, setShift] = useState(0);
  const [opacity, setOpacity] = useState(0.5);
  const [difference, setDifference] = useState(false);
  const { baseline_m } = evidence.at_vehicle;
  const rate = evidence.measurement.rig.line_rate_hz;
  const shifts: readonly (readonly [number | null, string])[] = EDGES.flatMap((edge) => [
    [shiftOf(hand, edge), say("opened-evidence-shift-hand", { edge })] as const,
    [shiftOf(evidence.measurement, edge), say("opened-evidence-shift-file", { edge })] as const,
  ]);
  return (
    <figure class="evidence__figure">
      <figcaption>{say("opened-evidence-overlay")}</figcaption>
      <div class="opened__tools">
        <label class="opened__filter">
          {say("opened-evidence-shift")}
          <input
            type="range"
            min={Math.min(0, 2 * apart)}
            max={Math.max(0, 2 * apart)}
            step={0.5}
            value={shift}
            data-shift="range"
            onInput={taken(setShift)}
          />
          <input
            type="number"
            class="evidence__line"
            step={0.5}
            value={shift}
            data-shift="number"
            aria-label={say("opened-evidence-shift")}
            onInput={taken(setShift)}
          />
        </label>
        <label class="opened__filter">
          {say("opened-evidence-opacity")}
          <input type="range" min={0} max={1} step={0.05} value={opacity} onInput={taken(setOpacity)} />
        </label>
        <label class="opened__filter">
          <input type="checkbox" checked={difference} onChange={() => setDifference(!difference)} />
          {say("opened-evidence-difference")}
        </label>
        {shifts.map(([lines, words]) => (
          <button
            key={words}
            type="button"
            class="evidence__button"
            disabled={lines === null}
            onClick={() => setShift(lines ?? 0)}
          >
            {words}
          </button>
        ))}
      </div>
      <div class="evidence__window">
        <svg
          class="evidence__strip evidence__strip--over"
          data-testid="overlay"
          style={{ width: `${100 * zoom}%` }}
          viewBox={`${first.start} 0 ${first.width} ${one.rows_px}`}
          preserveAspectRatio="none"
          role="img"
          aria-label={say("opened-evidence-overlay")}
        >
          <image
            href={addresses[0]}
            x={first.start}
            y={0}
            width={first.width}
            height={one.rows_px}
            preserveAspectRatio="none"
          />
          <image
            class={difference ? "evidence__over evidence__over--difference" : "evidence__over"}
            href={addresses[1]}
            x={second.start - shift}
            y={0}
            width={second.width}
            height={two.rows_px}
            opacity={difference ? 1 : opacity}
            preserveAspectRatio="none"
          />
        </svg>
      </div>
      <p data-testid="shift-words">
        {say("opened-evidence-shift-words", {
          lines: fixed(shift, 1),
          ms: fixed((1e3 * shift) / rate, 3),
          speed: speedWords(speedOf(Math.abs(shift), baseline_m, rate), say("opened-evidence-no-shift")),
        })}
      </p>
    </figure>
  );
}
