/** The start of a recording as a person confirms it: by the clocks of its place, with the zone they show. */

import type { VNode } from "preact";
import { useState } from "preact/hooks";
import { Button, Field, Segments, TextField } from "../../components";
import { ApiError } from "../../core/api";
import { say, wordsOf } from "../../core/messages";
import { survey } from "../../core/survey";
import { formatPlaceMoment, ownZone, placeTime, TIME_ZONES } from "../../core/times";
import type { Recording } from "../../core/types";

/** What is known of a start: confirmed, or proposed. */
export type Started = Pick<Recording, "started_local" | "time_zone" | "start_proposed">;

type StartTyped = ReturnType<typeof useStart>;

/** That of the survey's place, else the browser's. */
function usualZone(): string {
  return survey.value?.place.time_zone ?? ownZone();
}

/** "2026-05-03T08:10:00.250" without zeros that the box would not show. */
function shownLocal(started_local: string | null): string | null {
  return started_local?.slice(0, 23).replace(/\.000$/, "") ?? null;
}

/** In words: confirmed, proposed (of `proposed`), or the sentence that it is not known. */
export function startWords(of: Started, unknown: string): string {
  if (of.started_local && of.time_zone)
    return say("filmed-start", { time: formatPlaceMoment(of.started_local), zone: of.time_zone });
  const zone = usualZone();
  const local = of.start_proposed && placeTime(of.start_proposed, zone);
  return local ? say("filmed-proposed", { time: formatPlaceMoment(local), zone }) : unknown;
}

export function useStart(of: Started) {
  const [zone, setZone] = useState(of.time_zone ?? usualZone());
  const [typed, setTyped] = useState<string | null>(shownLocal(of.started_local));
  const [offset, setOffset] = useState<string>(of.started_local?.slice(-6) ?? "");
  /** The two offsets of an hour that the clocks showed twice, once the server has said so. */
  const [twice, setTwice] = useState<readonly string[]>([]);
  const proposed = of.start_proposed && placeTime(of.start_proposed, zone);
  const local = typed ?? proposed ?? "";
  /** Opened and left as it was: of an hour that came twice it is still the same one. */
  const unchanged = shownLocal(of.started_local) === local && of.time_zone === zone;
  return {
    local,
    zone,
    proposed,
    twice,
    offset,
    setLocal: (time: string) => {
      setTyped(time);
      setTwice([]);
      setOffset("");
    },
    setZone: (name: string) => {
      setZone(name);
      setTwice([]);
    },
    setOffset,
    /** What is to be stored; null where nothing was typed. */
    said: () =>
      local ? { local: local + (twice.length > 0 || unchanged ? offset : ""), time_zone: zone.trim() } : null,
    /** Stores it, and asks which of two hours is meant where that was the refusal. */
    learning: async (store: () => Promise<unknown>) => {
      try {
        await store();
      } catch (error) {
        const values =
          error instanceof ApiError && error.said?.code === "local-time-twice" ? error.said.values : null;
        if (values) setTwice([String(values["first"]), String(values["second"])]);
        throw error;
      }
    },
  };
}

const BUTTONS = wordsOf({ confirmed: "filmed-edit", proposed: "filmed-confirm", unknown: "filmed-enter" });

interface LineProps {
  testId: string;
  words: string;
  of: Started & { readonly name: string };
  /** Changes a start that is confirmed, in the words of a screen reader. */
  edit: string;
  mayChange: boolean;
  dialog: (close: () => void) => VNode;
}

/** What is known of a start in words, and the button to change it, to confirm what the file proposes, or to enter it. */
export function StartLine({ testId, words, of, edit, mayChange, dialog }: LineProps) {
  const [editing, setEditing] = useState(false);
  const state = of.started_local ? "confirmed" : of.start_proposed ? "proposed" : "unknown";
  const labels = {
    confirmed: edit,
    proposed: say("filmed-confirm-of", { recording: of.name }),
    unknown: say("filmed-enter-of", { recording: of.name }),
  };
  return (
    <div class="row row--wrap small" data-testid={testId}>
      <span>{words}</span>
      {mayChange && (
        <Button
          small
          kind={state === "confirmed" ? "quiet" : "plain"}
          label={labels[state]}
          onClick={() => setEditing(true)}
        >
          {BUTTONS[state]}
        </Button>
      )}
      {editing && dialog(() => setEditing(false))}
    </div>
  );
}

interface Props {
  start: StartTyped;
  label: string;
  hint: string;
  /** Of the box, seconds: how finely a start can be told. */
  step: string;
}

export function StartFields({ start, label, hint, step }: Props) {
  return (
    <>
      <Field label={label} hint={hint}>
        {(wiring) => (
          <span class="row">
            <input
              {...wiring}
              class="input"
              type="datetime-local"
              step={step}
              value={start.local}
              onInput={(event) => start.setLocal(event.currentTarget.value)}
            />
            {start.local && (
              <Button says="filmed-unsay" small kind="quiet" onClick={() => start.setLocal("")} />
            )}
          </span>
        )}
      </Field>
      {start.twice.length > 0 && (
        <Segments
          says="filmed-which"
          value={start.offset}
          onInput={start.setOffset}
          options={start.twice.map((one, n) => ({
            value: one,
            label: say(n === 0 ? "filmed-first" : "filmed-second", { offset: one }),
          }))}
        />
      )}
      <TextField says="filmed-zone" value={start.zone} suggestions={TIME_ZONES} onInput={start.setZone} />
    </>
  );
}
