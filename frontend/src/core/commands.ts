/** The one key map. `?` shows it, the person can change it, overrides live in local storage. */
import { computed } from "@preact/signals";
import { useLayoutEffect, useRef } from "preact/hooks";
import { say, wordsOf } from "./messages";
import { stored } from "./stored";

/** Where an action listens. "point" lies on top of "frames": while a point is selected the arrows move it, not the frame. */
export type Scope = "anywhere" | "frames" | "measure" | "point" | "scan" | "review";

export interface Action {
  scope: Scope;
  keys: readonly string[];
}

export const ACTIONS = {
  help: { scope: "anywhere", keys: ["?", "F1"] },

  frameNext: { scope: "frames", keys: ["F", "ArrowRight"] },
  framePrevious: { scope: "frames", keys: ["D", "ArrowLeft"] },
  frameNextTen: { scope: "frames", keys: ["V", "Shift+ArrowRight"] },
  framePreviousTen: { scope: "frames", keys: ["C", "Shift+ArrowLeft"] },
  secondNext: { scope: "frames", keys: ["PageDown"] },
  secondPrevious: { scope: "frames", keys: ["PageUp"] },
  frameFirst: { scope: "frames", keys: ["Home"] },
  frameLast: { scope: "frames", keys: ["End"] },
  frameGo: { scope: "frames", keys: ["G"] },
  play: { scope: "frames", keys: ["Space"] },
  loupe: { scope: "frames", keys: ["Z"] },
  loupeToggle: { scope: "frames", keys: ["L"] },
  linesToggle: { scope: "frames", keys: ["H"] },
  brightToggle: { scope: "frames", keys: ["I"] },
  cursor: { scope: "frames", keys: ["M"] },
  place: { scope: "frames", keys: ["Enter"] },
  zoomIn: { scope: "frames", keys: ["+", "="] },
  zoomOut: { scope: "frames", keys: ["-"] },
  zoomFit: { scope: "frames", keys: ["0"] },

  passNext: { scope: "measure", keys: ["N"] },
  passPrevious: { scope: "measure", keys: ["P"] },
  target1: { scope: "measure", keys: ["1"] },
  target2: { scope: "measure", keys: ["2"] },
  target3: { scope: "measure", keys: ["3"] },
  target4: { scope: "measure", keys: ["4"] },
  target5: { scope: "measure", keys: ["5"] },
  newContact: { scope: "measure", keys: ["T"] },
  driverSide: { scope: "measure", keys: ["E"] },
  notVisible: { scope: "measure", keys: ["X"] },
  secondFrame: { scope: "measure", keys: ["S"] },
  followPass: { scope: "measure", keys: ["Shift+S"] },
  proposeContact: { scope: "measure", keys: ["A"] },
  selectNext: { scope: "measure", keys: ["W"] },
  bestFrame: { scope: "measure", keys: ["B"] },
  record: { scope: "measure", keys: ["Shift+C"] },
  recentModel1: { scope: "measure", keys: ["6"] },
  recentModel2: { scope: "measure", keys: ["7"] },
  recentModel3: { scope: "measure", keys: ["8"] },
  recentModel4: { scope: "measure", keys: ["9"] },
  whichModel: { scope: "measure", keys: ["Shift+M"] },
  passBegin: { scope: "measure", keys: ["["] },
  passEnd: { scope: "measure", keys: ["]"] },
  passSplit: { scope: "measure", keys: ["Shift+K"] },
  passJoin: { scope: "measure", keys: ["Shift+J"] },
  passDiscard: { scope: "measure", keys: ["Shift+Delete"] },
  confirmNext: { scope: "measure", keys: ["Ctrl+Enter"] },
  undo: { scope: "measure", keys: ["Ctrl+Z"] },
  redo: { scope: "measure", keys: ["Ctrl+Shift+Z", "Ctrl+Y"] },
  remove: { scope: "measure", keys: ["Delete"] },
  cancel: { scope: "measure", keys: ["Escape"] },

  nudgeLeft: { scope: "point", keys: ["ArrowLeft"] },
  nudgeRight: { scope: "point", keys: ["ArrowRight"] },
  nudgeUp: { scope: "point", keys: ["ArrowUp"] },
  nudgeDown: { scope: "point", keys: ["ArrowDown"] },
  nudgeLeftFar: { scope: "point", keys: ["Shift+ArrowLeft"] },
  nudgeRightFar: { scope: "point", keys: ["Shift+ArrowRight"] },
  nudgeUpFar: { scope: "point", keys: ["Shift+ArrowUp"] },
  nudgeDownFar: { scope: "point", keys: ["Shift+ArrowDown"] },
  nudgeLeftFine: { scope: "point", keys: ["Alt+ArrowLeft"] },
  nudgeRightFine: { scope: "point", keys: ["Alt+ArrowRight"] },
  nudgeUpFine: { scope: "point", keys: ["Alt+ArrowUp"] },
  nudgeDownFine: { scope: "point", keys: ["Alt+ArrowDown"] },

  scanFit: { scope: "scan", keys: ["Q"] },
  scanTaller: { scope: "scan", keys: ["R"] },
  scanFlatter: { scope: "scan", keys: ["Shift+R"] },
  scanWheels: { scope: "scan", keys: ["U"] },
  scanNew: { scope: "scan", keys: ["O"] },
  scanHeight: { scope: "scan", keys: ["Y"] },
  scanRod: { scope: "scan", keys: ["Shift+Y"] },

  reviewAccept: { scope: "review", keys: ["A"] },
  reviewReject: { scope: "review", keys: ["X"] },
  reviewFix: { scope: "review", keys: ["E"] },
  reviewNext: { scope: "review", keys: ["J"] },
  reviewPrevious: { scope: "review", keys: ["K"] },
  reviewReason1: { scope: "review", keys: ["1"] },
  reviewReason2: { scope: "review", keys: ["2"] },
  reviewReason3: { scope: "review", keys: ["3"] },
  reviewReason4: { scope: "review", keys: ["4"] },
  reviewReason5: { scope: "review", keys: ["5"] },
  reviewReason6: { scope: "review", keys: ["6"] },
} as const satisfies Record<string, Action>;

export type ActionId = keyof typeof ACTIONS;
export type Overrides = Partial<Record<ActionId, string[]>>;
export type KeyMap = Record<ActionId, readonly string[]>;

export function commandName(id: ActionId): string {
  return say(`command-${id}`);
}

export const SCOPE_NAMES = wordsOf("scope-");

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
  return ALWAYS_RESERVED.has(chord) ? say("keys-reserved", { chord: showChord(chord) }) : null;
}

function overlap(a: Scope, b: Scope): boolean {
  if (a === b || a === "anywhere" || b === "anywhere") return true;
  const pair = new Set([a, b]);
  if (pair.has("point") && pair.has("frames")) return false; // a selected point takes the arrows on purpose
  return !(pair.has("measure") && pair.has("review"));
}

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
  "-": "−",
};
const KEY_WORDS: Readonly<Record<string, string>> = wordsOf("key-");

/** A chord as a keycap shows it. */
export function showChord(chord: string): string {
  if (chord === "+") return "+";
  return chord
    .split(/\+(?=.)/)
    .map((part) => SIGNS[part] ?? KEY_WORDS[part] ?? part)
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
  // of the layout, so that a key serves as soon as what it does is seen
  useLayoutEffect(() => addCommands(() => latest.current), []);
}

export function addCommands(commands: Layer): () => void {
  layers.push(commands);
  return () => {
    layers.splice(layers.indexOf(commands), 1);
  };
}

export function labelOf({ id, label }: Pick<Command, "id" | "label">): string {
  return label ?? commandName(id);
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

// A list that was chosen from with the pointer is left: else the next key, meant as a command, chooses another of its lines.
let pointed: EventTarget | null = null;
const noted = ({ type, target }: Event): void => {
  pointed = type === "pointerdown" ? target : null;
};
for (const type of ["pointerdown", "keydown"]) window.addEventListener(type, noted, true);
window.addEventListener("change", ({ target }) => {
  if (target instanceof HTMLSelectElement && target === pointed) target.blur();
});
