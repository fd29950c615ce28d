import { useEffect, useState } from "preact/hooks";
import { Button } from "../components/Button";
import { Dialog } from "../components/Dialog";
import { Notice } from "../components/Feedback";
import {
  ACTIONS,
  type ActionId,
  chordOf,
  conflicts,
  keyMap,
  overrides,
  reservedReason,
  SCOPE_NAMES,
  type Scope,
  showChord,
} from "../core/commands";
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

  const clashes = conflicts(keyMap.value);
  const changed = Object.keys(overrides.value).length > 0;
  return (
    <Dialog
      wide
      title="Keys"
      onClose={() => {
        keysShown.value = false;
      }}
      actions={
        <Button
          disabled={!changed}
          onClick={() => {
            overrides.value = {};
          }}
        >
          Back to the usual keys
        </Button>
      }
    >
      <div class="stack">
        {problem && <Notice kind="warning">{problem}</Notice>}
        {clashes.map(({ chord, actions: [a, b] }) => (
          <Notice kind="warning" key={`${a}${b}${chord}`}>
            {showChord(chord)} now means both “{ACTIONS[a].label}” and “{ACTIONS[b].label}”; the first one
            wins.
          </Notice>
        ))}
        <div class="keys">
          {(Object.keys(SCOPE_NAMES) as Scope[]).map((scope) => (
            <section key={scope}>
              <h3>{SCOPE_NAMES[scope]}</h3>
              <table class="table">
                <tbody>
                  {(Object.keys(ACTIONS) as ActionId[])
                    .filter((id) => ACTIONS[id].scope === scope)
                    .map((id) => (
                      <KeyRow key={id} id={id} listening={listening === id} listen={setListening} />
                    ))}
                </tbody>
              </table>
            </section>
          ))}
        </div>
        <p class="muted small">
          Wheel: zoom at the pointer. Drag with the middle button, or with Space held: move the picture.
        </p>
      </div>
    </Dialog>
  );
}

function KeyRow({
  id,
  listening,
  listen,
}: {
  id: ActionId;
  listening: boolean;
  listen: (id: ActionId | null) => void;
}) {
  return (
    <tr>
      <td class="small">{ACTIONS[id].label}</td>
      <td class="num">
        <button
          type="button"
          class="keys__change"
          aria-label={`${ACTIONS[id].label}: ${keyMap.value[id].map(showChord).join(" or ")}. Change`}
          title="Change the key"
          onClick={() => listen(listening ? null : id)}
        >
          {listening
            ? "press a key…"
            : keyMap.value[id].map((chord) => <kbd key={chord}>{showChord(chord)}</kbd>)}
        </button>
      </td>
    </tr>
  );
}
