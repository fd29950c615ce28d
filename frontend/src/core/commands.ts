/** The one key map. `?` shows it, the person can change it, overrides live in local storage. */
import { computed } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";
import { stored } from "./stored";

/** Where an action listens. "point" lies on top of "frames": while a point is selected the arrows move it, not the frame. */
export type Scope = "anywhere" | "frames" | "measure" | "point" | "scan" | "review";

export interface Action {
  label: string;
  scope: Scope;
  keys: readonly string[];
}

export const ACTIONS = {
  help: { label: "Show the keys", scope: "anywhere", keys: ["?", "F1"] },

  frameNext: { label: "Next frame", scope: "frames", keys: ["F", "ArrowRight"] },
  framePrevious: { label: "Previous frame", scope: "frames", keys: ["D", "ArrowLeft"] },
  frameNextTen: { label: "Ten frames on", scope: "frames", keys: ["V", "Shift+ArrowRight"] },
  framePreviousTen: { label: "Ten frames back", scope: "frames", keys: ["C", "Shift+ArrowLeft"] },
  secondNext: { label: "One second on", scope: "frames", keys: ["PageDown"] },
  secondPrevious: { label: "One second back", scope: "frames", keys: ["PageUp"] },
  frameFirst: { label: "First frame", scope: "frames", keys: ["Home"] },
  frameLast: { label: "Last frame", scope: "frames", keys: ["End"] },
  frameGo: { label: "Go to a frame", scope: "frames", keys: ["G"] },
  play: { label: "Play and stop", scope: "frames", keys: ["Space"] },
  loupe: { label: "Loupe, while held", scope: "frames", keys: ["Z"] },
  loupeToggle: { label: "Loupe on and off", scope: "frames", keys: ["L"] },
  linesToggle: { label: "Hide and show the lines", scope: "frames", keys: ["H"] },
  brightToggle: { label: "Brighten the picture, for display only", scope: "frames", keys: ["I"] },
  cursor: { label: "Place points by keyboard: cursor on and off", scope: "frames", keys: ["M"] },
  place: { label: "Place the point at the cursor", scope: "frames", keys: ["Enter"] },
  zoomIn: { label: "Zoom in", scope: "frames", keys: ["+", "="] },
  zoomOut: { label: "Zoom out", scope: "frames", keys: ["-"] },
  zoomFit: { label: "Fit the frame", scope: "frames", keys: ["0"] },

  passNext: { label: "Next pass", scope: "measure", keys: ["N"] },
  passPrevious: { label: "Previous pass", scope: "measure", keys: ["P"] },
  target1: { label: "Target: roof", scope: "measure", keys: ["1"] },
  target2: { label: "Target: driver's eye", scope: "measure", keys: ["2"] },
  target3: { label: "Target: taillight", scope: "measure", keys: ["3"] },
  target4: { label: "Target: headlight", scope: "measure", keys: ["4"] },
  target5: { label: "Target: other", scope: "measure", keys: ["5"] },
  newContact: { label: "New contact point", scope: "measure", keys: ["T"] },
  secondFrame: { label: "Second frame: click the same two points there", scope: "measure", keys: ["S"] },
  proposeContact: { label: "Propose the tyre's contact at the pointer", scope: "measure", keys: ["A"] },
  selectNext: { label: "Select the next point", scope: "measure", keys: ["W"] },
  bestFrame: { label: "Best frame of the pass", scope: "measure", keys: ["B"] },
  passBegin: { label: "Mark the first frame of a pass or the board", scope: "measure", keys: ["["] },
  passEnd: { label: "Mark the last frame of a pass or the board", scope: "measure", keys: ["]"] },
  passSplit: { label: "Split the pass before this frame", scope: "measure", keys: ["K"] },
  passJoin: { label: "Join the pass with the next one", scope: "measure", keys: ["J"] },
  passDiscard: { label: "Discard the pass", scope: "measure", keys: ["Shift+Delete"] },
  confirmNext: { label: "Confirm and go to the next pass", scope: "measure", keys: ["Ctrl+Enter"] },
  undo: { label: "Undo", scope: "measure", keys: ["Ctrl+Z"] },
  redo: { label: "Redo", scope: "measure", keys: ["Ctrl+Shift+Z", "Ctrl+Y"] },
  remove: { label: "Withdraw the selected measurement", scope: "measure", keys: ["Delete"] },
  cancel: { label: "Let go of the point, close", scope: "measure", keys: ["Escape"] },

  nudgeLeft: { label: "Move the point left 1 px", scope: "point", keys: ["ArrowLeft"] },
  nudgeRight: { label: "Move the point right 1 px", scope: "point", keys: ["ArrowRight"] },
  nudgeUp: { label: "Move the point up 1 px", scope: "point", keys: ["ArrowUp"] },
  nudgeDown: { label: "Move the point down 1 px", scope: "point", keys: ["ArrowDown"] },
  nudgeLeftFar: { label: "Move the point left 10 px", scope: "point", keys: ["Shift+ArrowLeft"] },
  nudgeRightFar: { label: "Move the point right 10 px", scope: "point", keys: ["Shift+ArrowRight"] },
  nudgeUpFar: { label: "Move the point up 10 px", scope: "point", keys: ["Shift+ArrowUp"] },
  nudgeDownFar: { label: "Move the point down 10 px", scope: "point", keys: ["Shift+ArrowDown"] },
  nudgeLeftFine: { label: "Move the point left 0.1 px", scope: "point", keys: ["Alt+ArrowLeft"] },
  nudgeRightFine: { label: "Move the point right 0.1 px", scope: "point", keys: ["Alt+ArrowRight"] },
  nudgeUpFine: { label: "Move the point up 0.1 px", scope: "point", keys: ["Alt+ArrowUp"] },
  nudgeDownFine: { label: "Move the point down 0.1 px", scope: "point", keys: ["Alt+ArrowDown"] },

  scanFit: { label: "Fill the window with the vehicle", scope: "scan", keys: ["Q"] },
  scanTaller: { label: "Stretch the height", scope: "scan", keys: ["R"] },
  scanFlatter: { label: "Flatten the height", scope: "scan", keys: ["Shift+R"] },
  scanWheels: { label: "Click both wheels for the wheelbase", scope: "scan", keys: ["U"] },
  scanNew: { label: "Add a vehicle by its front and rear", scope: "scan", keys: ["O"] },
  scanHeight: { label: "Measure heights by contact and target", scope: "scan", keys: ["Y"] },
  scanRod: { label: "Calibrate the height with a rod", scope: "scan", keys: ["Shift+Y"] },

  reviewAccept: { label: "Accept", scope: "review", keys: ["A"] },
  reviewReject: { label: "Reject", scope: "review", keys: ["X"] },
  reviewFix: { label: "Fix", scope: "review", keys: ["E"] },
  reviewNext: { label: "Next measurement", scope: "review", keys: ["J"] },
  reviewPrevious: { label: "Previous measurement", scope: "review", keys: ["K"] },
} as const satisfies Record<string, Action>;

export type ActionId = keyof typeof ACTIONS;
export type Overrides = Partial<Record<ActionId, string[]>>;
export type KeyMap = Record<ActionId, readonly string[]>;

export const SCOPE_NAMES: Record<Scope, string> = {
  anywhere: "Everywhere",
  frames: "Frames",
  measure: "Measure",
  point: "A selected point",
  scan: "Line scan",
  review: "Review",
};

export const overrides = stored<Overrides>("keys", {}, (v) => typeof v === "object" && v !== null);

export function mergeKeys(changed: Overrides): KeyMap {
  const map = {} as Record<ActionId, readonly string[]>;
  for (const id of Object.keys(ACTIONS) as ActionId[]) map[id] = changed[id] ?? ACTIONS[id].keys;
  return map;
}

export const keyMap = computed(() => mergeKeys(overrides.value));

/** The chord of a key press, as the map spells it: "Ctrl+Shift+Z", "ArrowLeft", "?". Cmd counts as Ctrl. */
export function chordOf(
  event: Pick<KeyboardEvent, "key" | "ctrlKey" | "metaKey" | "altKey" | "shiftKey">,
): string {
  let key = event.key === " " ? "Space" : event.key;
  const letter = key.length === 1 && key.toUpperCase() !== key.toLowerCase();
  if (letter) key = key.toUpperCase();
  const parts: string[] = [];
  if (event.ctrlKey || event.metaKey) parts.push("Ctrl");
  if (event.altKey) parts.push("Alt");
  // a sign such as "?" already holds its Shift; a letter or a named key does not
  if (event.shiftKey && (letter || key.length > 1)) parts.push("Shift");
  return [...parts, key].join("+");
}

const ALWAYS_RESERVED = new Set([
  "Ctrl+W",
  "Ctrl+T",
  "Ctrl+N",
  "Ctrl+Shift+N",
  "Ctrl+Shift+T",
  "Ctrl+Tab",
  "F5",
  "F11",
  "F12",
  "Tab",
  "Shift+Tab",
]);

/** Why a chord cannot be used at all, or null. */
export function reservedReason(chord: string): string | null {
  return ALWAYS_RESERVED.has(chord)
    ? `The browser keeps ${showChord(chord)} for itself; choose another key.`
    : null;
}

function overlap(a: Scope, b: Scope): boolean {
  if (a === b || a === "anywhere" || b === "anywhere") return true;
  const pair = new Set([a, b]);
  if (pair.has("point") && pair.has("frames")) return false; // a selected point takes the arrows on purpose
  return !(pair.has("measure") && pair.has("review"));
}

/** Pairs of actions that answer to the same chord in the same place. */
export function conflicts(map: KeyMap): { chord: string; actions: [ActionId, ActionId] }[] {
  const found: { chord: string; actions: [ActionId, ActionId] }[] = [];
  const ids = Object.keys(map) as ActionId[];
  ids.forEach((a, i) => {
    for (const b of ids.slice(i + 1)) {
      if (!overlap(ACTIONS[a].scope, ACTIONS[b].scope)) continue;
      for (const chord of map[a]) if (map[b].includes(chord)) found.push({ chord, actions: [a, b] });
    }
  });
  return found;
}

const SIGNS: Record<string, string> = {
  ArrowLeft: "←",
  ArrowRight: "→",
  ArrowUp: "↑",
  ArrowDown: "↓",
  PageUp: "PgUp",
  PageDown: "PgDn",
  Delete: "Del",
  Escape: "Esc",
  "-": "−",
};

/** A chord as a keycap shows it. */
export function showChord(chord: string): string {
  if (chord === "+") return "+";
  return chord
    .split(/\+(?=.)/)
    .map((part) => SIGNS[part] ?? part)
    .join(" ");
}

/** The first key of an action, for titles: "Undo (Ctrl Z)". */
export function hint(id: ActionId): string {
  const first = keyMap.value[id][0];
  return first ? ` (${showChord(first)})` : "";
}

/** What can be done, as one object: its key, its button, its line in a menu and in the `?` dialog come from here. */
export interface Command {
  readonly id: ActionId;
  /** Its words on this screen, where those of the key map do not fit. */
  readonly label?: string;
  /** A held key is told of going down and of coming up again; any other is always "down". */
  readonly held?: boolean;
  /** Answer false to let others have the key. */
  // biome-ignore lint/suspicious/noConfusingVoidType: most commands answer nothing
  run(down: boolean): boolean | void;
  /** False: its button is dimmed and its key is free for others. */
  enabled?(): boolean;
  /** Of a switch: whether it is on. */
  pressed?(): boolean;
}

type Layer = () => readonly Command[];

const layers: Layer[] = [];

/** Listens to the keys of these commands while the component is shown. The layer added last is asked first. */
export function useCommands(commands: readonly Command[]): void {
  const latest = useRef(commands);
  latest.current = commands;
  useEffect(() => addCommands(() => latest.current), []);
}

export function addCommands(commands: Layer): () => void {
  layers.push(commands);
  return () => {
    layers.splice(layers.indexOf(commands), 1);
  };
}

/** What a command is called here. */
export function labelOf({ id, label }: Pick<Command, "id" | "label">): string {
  return label ?? ACTIONS[id].label;
}

/** The commands that listen now, one for each action: the one that is asked first. */
export function commandsHere(): Map<ActionId, Command> {
  const here = new Map<ActionId, Command>();
  for (const layer of [...layers].reverse())
    for (const command of layer()) if (!here.has(command.id)) here.set(command.id, command);
  return here;
}

function isTyping(target: EventTarget | null): boolean {
  if (!(target instanceof HTMLElement)) return false;
  if (target instanceof HTMLInputElement)
    return !["checkbox", "radio", "button", "range", "file"].includes(target.type);
  return (
    target.isContentEditable || target instanceof HTMLTextAreaElement || target instanceof HTMLSelectElement
  );
}

/** Space and Enter on a button, arrows on a radio belong to that control. */
function controlWants(target: EventTarget | null, chord: string): boolean {
  if (!(target instanceof HTMLElement)) return false;
  if (chord === "Space" || chord === "Enter")
    return target.closest("button, a, summary, input, [role=button], [role=option]") !== null;
  if (chord.startsWith("Arrow"))
    return target.closest("input[type=radio], input[type=range], [role=listbox], [role=menu]") !== null;
  return false;
}

/** Runs the action of a key press. */
function dispatch(event: KeyboardEvent, down: boolean): boolean {
  if (event.defaultPrevented || document.querySelector("dialog[open]")) return false;
  const chord = chordOf(event);
  const typingAllowed = /^(Ctrl\+|F1$)/.test(chord) && !/^Ctrl\+(Shift\+)?[ZY]$/.test(chord);
  if (isTyping(event.target) && !typingAllowed) return false;
  if (down && controlWants(event.target, chord)) return false;
  const ids = down
    ? actionsWhere((chords) => chords.includes(chord))
    : actionsWhere((chords) => chords.some((k) => k.split("+").at(-1) === chordKey(event)));
  return [...layers].reverse().some((layer) => ids.some((id) => runs(layer, id, event, down)));
}

/** "point" goes before the scopes it lies on. */
function actionsWhere(fits: (chords: readonly string[]) => boolean): ActionId[] {
  return (Object.keys(ACTIONS) as ActionId[])
    .filter((id) => fits(keyMap.value[id]))
    .sort((a, b) => Number(ACTIONS[b].scope === "point") - Number(ACTIONS[a].scope === "point"));
}

/** True if the layer has taken the key. */
function runs(layer: Layer, id: ActionId, event: KeyboardEvent, down: boolean): boolean {
  return layer().some((command) => command.id === id && take(command, event, down));
}

/** A held key that repeats is taken and does nothing more. */
function take(command: Command, event: KeyboardEvent, down: boolean): boolean {
  if ((!down && !command.held) || command.enabled?.() === false) return false;
  if (down && event.repeat && command.held) return true;
  return command.run(down) !== false;
}

function chordKey(event: KeyboardEvent): string | undefined {
  return chordOf({ key: event.key, ctrlKey: false, metaKey: false, altKey: false, shiftKey: false });
}

window.addEventListener("keydown", (event) => {
  if (dispatch(event, true)) event.preventDefault();
});
window.addEventListener("keyup", (event) => {
  dispatch(event, false);
});
