import { useEffect, useState } from "preact/hooks";
import { Button } from "../components/Button";
import { Dialog } from "../components/Dialog";
import { Notice } from "../components/Feedback";
import {
  ACTIONS,
  type ActionId,
  chordOf,
  commandName,
  commandsHere,
  conflicts,
  keyMap,
  labelOf,
  overrides,
  reservedReason,
  SCOPE_NAMES,
  type Scope,
  showChord,
} from "../core/commands";
import { anyOf, say } from "../core/messages";
import { keysShown } from "./KeysDialog.state";

/** The key map, shown by `?`: every action with its keys; press "change", then the new key. */
export default function KeysDialog() {
  const [listening, setListening] = useState<ActionId | null>(null);
  const [problem, setProblem] = useState<string | null>(null);
  useEffect(() => {
    if (listening === null) return;
    const take = (event: KeyboardEvent) => {
      if (["Shift", "Control", "Alt", "Meta"].includes(event.key)) return;
      event.preventDefault();
      event.stopPropagation();
      const chord = chordOf(event);
      const reason = reservedReason(chord);
      setProblem(reason);
      if (!reason) overrides.value = { ...overrides.value, [listening]: [chord] };
      setListening(null);
    };
    window.addEventListener("keydown", take, true);
    return () => window.removeEventListener("keydown", take, true);
  }, [listening]);

  const ids = Object.keys(ACTIONS) as ActionId[];
  const here = commandsHere();
  const wordsOf = (id: ActionId): string => labelOf(here.get(id) ?? { id });
  const rows = { wordsOf, listening, listen: setListening };
  const clashes = conflicts(keyMap.value);
  const changed = Object.keys(overrides.value).length > 0;
  return (
    <Dialog
      wide
      title={say("app-keys")}
      onClose={() => {
        keysShown.value = false;
      }}
      actions={
        <Button
          says="keys-usual"
          disabled={!changed}
          onClick={() => {
            overrides.value = {};
          }}
        />
      }
    >
      <div class="stack">
        {problem && <Notice kind="warning">{problem}</Notice>}
        {clashes.map(({ chord, actions: [a, b] }) => (
          <Notice kind="warning" key={`${a}${b}${chord}`}>
            {say("keys-clash", { chord: showChord(chord), one: commandName(a), other: commandName(b) })}
          </Notice>
        ))}
        <p class="small">{say("keys-how")}</p>
        <KeyTables ids={ids.filter((id) => here.has(id))} {...rows} />
        {ids.some((id) => !here.has(id)) && (
          <details>
            <summary>{say("keys-elsewhere")}</summary>
            <KeyTables ids={ids.filter((id) => !here.has(id))} {...rows} />
          </details>
        )}
        <p class="muted small">{say("keys-wheel")}</p>
      </div>
    </Dialog>
  );
}

interface Rows {
  wordsOf(id: ActionId): string;
  listening: ActionId | null;
  listen(id: ActionId | null): void;
}

/** Those of the page first, then what goes for every picture. */
const SCOPES: readonly Scope[] = ["measure", "review", "scan", "point", "frames", "anywhere"];

function KeyTables({ ids, ...rows }: Rows & { ids: readonly ActionId[] }) {
  const scopes = SCOPES.filter((scope) => ids.some((id) => ACTIONS[id].scope === scope));
  return (
    <div class="keys">
      {scopes.map((scope) => (
        <section key={scope}>
          <h3>{SCOPE_NAMES[scope]}</h3>
          <table class="table">
            <tbody>
              {ids
                .filter((id) => ACTIONS[id].scope === scope)
                .map((id) => (
                  <KeyRow key={id} id={id} {...rows} />
                ))}
            </tbody>
          </table>
        </section>
      ))}
    </div>
  );
}

function KeyRow({ id, wordsOf, listening, listen }: Rows & { id: ActionId }) {
  const waits = listening === id;
  return (
    <tr>
      <td class="small">{wordsOf(id)}</td>
      <td class="num">
        <button
          type="button"
          class="keys__change"
          aria-label={say("keys-of", { command: wordsOf(id), keys: anyOf(keyMap.value[id].map(showChord)) })}
          title={say("keys-change")}
          onClick={() => listen(waits ? null : id)}
        >
          {waits
            ? say("keys-press")
            : keyMap.value[id].map((chord) => <kbd key={chord}>{showChord(chord)}</kbd>)}
        </button>
      </td>
    </tr>
  );
}
