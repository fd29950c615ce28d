/** Ten measurements to click again, one after the other, without their points; Esc stops, Ctrl+Z takes the last back. */
import { useEffect, useMemo } from "preact/hooks";
import { Button, Empty, Loading, Problem } from "../../components";
import { CommandButton } from "../../components/CommandButton";
import { historyCommands } from "../../components/undoTools";
import { navigate, query } from "../../core/address";
import { useCommands } from "../../core/commands";
import type { ScreenProps } from "../../core/places";
import { plural } from "../../core/units";
import { TARGET_WORDS } from "../../core/words";
import { BlindFrame } from "../../viewer/BlindFrame";
import { frameCommands } from "../../viewer/stageCommands";
import { Transport } from "../../viewer/Transport";
import { AgainSession } from "./session";
import "./repeats.css";

export default function ClickAgainScreen({ surveyId }: ScreenProps) {
  const onlyOwn = query.value.get("of") !== "all";
  const session = useMemo(() => new AgainSession(surveyId, onlyOwn), [surveyId, onlyOwn]);
  useEffect(() => {
    void session.load();
    return () => session.close();
  }, [session]);
  const results = `/surveys/${surveyId}/repeats`;
  const { undo, redo } = useMemo(() => commandsOf(session), [session]);
  useCommands([
    undo,
    redo,
    ...frameCommands(session.stage, session.reel.player.value),
    { id: "cancel", label: "Stop", run: () => navigate(results) },
  ]);
  const items = session.items.value;
  const player = session.reel.player.value;
  if (session.problem.value) {
    return (
      <div class="page">
        <Problem error={session.problem.value} again={() => void session.load()} />
      </div>
    );
  }
  if (items === null) return <Loading what="what to click again" />;
  const item = session.current.value;
  if (items.length === 0) return <NothingToClick surveyId={surveyId} onlyOwn={onlyOwn} />;
  return (
    <div class="again">
      <h1 class="visually-hidden">Click again</h1>
      <header class="again__head">
        <p data-testid="again-progress">
          {item ? (
            <>
              <strong>
                {session.at.value + 1} of {items.length}
              </strong>{" "}
              <span class="muted">
                vehicle {String(item.vehicle_number).padStart(2, "0")}, {TARGET_WORDS[item.target]}
              </span>
            </>
          ) : (
            <strong>{plural(session.stored.value, "repeat")} stored</strong>
          )}
        </p>
        <span class="grow" />
        <CommandButton command={undo} kind="plain">
          Take the last back
        </CommandButton>
        {item && (
          <Button small onClick={() => session.skip()}>
            Pass over
          </Button>
        )}
        <Button small kind={item ? "quiet" : "primary"} href={results}>
          {item ? "Stop" : "See what they say"}
        </Button>
      </header>
      {item && player ? (
        <>
          <section class="again__frame" aria-label="Frame">
            <BlindFrame
              key={player.recordingId}
              blind={session.blind}
              player={player}
              stage={session.stage}
            />
          </section>
          <section class="again__time frame-tools" aria-label="Frames">
            <Transport player={player} stage={session.stage} />
            <span class="grow" />
            {player.shown.value?.frame !== item.frame && (
              <Button small onClick={() => session.showFrame()}>
                Back to frame {item.frame}
              </Button>
            )}
          </section>
        </>
      ) : (
        <Empty title="That was the last one">
          <p>Each was stored as a repeat: it stands in no list and changes no result.</p>
        </Empty>
      )}
    </div>
  );
}

function NothingToClick({ surveyId, onlyOwn }: { surveyId: number; onlyOwn: boolean }) {
  return (
    <div class="page">
      <h1 class="visually-hidden">Click again</h1>
      <Empty
        title={onlyOwn ? "You have clicked nothing yet" : "Nothing is measured yet"}
        actions={
          <>
            {onlyOwn && (
              <Button kind="primary" href={`/surveys/${surveyId}/repeats/click?of=all`}>
                Click 10 of anybody’s again
              </Button>
            )}
            <Button href={`/surveys/${surveyId}/measure`}>Go to measuring</Button>
          </>
        }
      >
        <p>
          {onlyOwn
            ? "How well you repeat yourself shows once you have measured something in this survey."
            : "Measure some vehicles first; then they can be clicked again."}
        </p>
      </Empty>
    </div>
  );
}

function commandsOf(session: AgainSession) {
  return historyCommands(session.history, {
    back: () => session.stage.back() || session.blind.busy.value,
    inHand: () => session.blind.contact.value !== null,
  });
}
