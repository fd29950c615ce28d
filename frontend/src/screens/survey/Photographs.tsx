import { useEffect, useState } from "preact/hooks";
import { DropFiles, Icon, IconButton, Problem } from "../../components";
import { api } from "../../core/api";
import { say } from "../../core/messages";
import { useAsked } from "../../core/resource";
import { may } from "../../core/session";
import { toast, toastProblem } from "../../core/toasts";
import type { Photograph } from "../../core/types";
import { useOneByOne } from "../../parts/uploads/oneByOne";
import "./photographs.css";

/** Pictures of the set-up: added, captioned, put in order; the report shows them in this order. */
export function Photographs({ surveyId }: { surveyId: number }) {
  const where = { survey_id: surveyId };
  const read = useAsked("GET /surveys/{survey_id}/photographs", where);
  const work = usePhotographs(where, read.data ?? [], read.set, read.reload);
  const mayChange = may("operator");
  if (!read.data) return <Problem error={read.error} />;
  if (read.data.length === 0 && !mayChange) return null;
  return (
    <section class="stack stack--near photographs" aria-labelledby="photographs-title">
      <h2 id="photographs-title">{say("photographs-title")}</h2>
      <p class="muted">{say("photographs-help")}</p>
      {read.data.length > 0 && (
        <ol class="grid grid--fill" style={{ "--least": "240px" }}>
          {read.data.map((one, place, all) => (
            <Card
              key={one.id}
              one={one}
              mayChange={mayChange}
              earlier={place > 0 ? () => work.move(place, place - 1) : null}
              later={place < all.length - 1 ? () => work.move(place, place + 1) : null}
              caption={(text) => work.caption(one, text)}
              remove={() => work.remove(one)}
            />
          ))}
        </ol>
      )}
      {work.refused.map(({ name, problem }) => (
        <p key={name} class="field__problem">
          <Icon name="warning" size={14} />
          {problem}
        </p>
      ))}
      {mayChange && (
        <DropFiles
          label={say("photographs-choose")}
          title={
            work.waiting > 0 ? say("photographs-adding", { count: work.waiting }) : say("photographs-drop")
          }
          hint={say("photographs-hint")}
          accept="image/jpeg,image/png,image/webp,image/tiff,.jpg,.jpeg,.png,.webp,.tif,.tiff"
          disabled={work.waiting > 0}
          add={work.add}
        />
      )}
    </section>
  );
}

interface CardProps {
  one: Photograph;
  mayChange: boolean;
  earlier: (() => void) | null;
  later: (() => void) | null;
  caption: (text: string) => void;
  remove: () => void;
}

function Card({ one, mayChange, earlier, later, caption, remove }: CardProps) {
  const [text, setText] = useState(one.caption);
  useEffect(() => setText(one.caption), [one.caption]);
  const photograph = one.caption || one.name;
  return (
    <li class="stack stack--tight photograph">
      <a
        class="photograph__picture"
        href={one.url}
        target="_blank"
        rel="noreferrer"
        title={say("photographs-open", { photograph })}
      >
        <img src={one.url} alt={photograph} loading="lazy" />
      </a>
      {mayChange ? (
        <>
          <textarea
            class="input"
            rows={2}
            value={text}
            maxLength={500}
            placeholder={say("photographs-what")}
            aria-label={say("photographs-caption", { photograph: one.name })}
            onInput={(event) => setText(event.currentTarget.value)}
            onChange={(event) => caption(event.currentTarget.value)}
          />
          <div class="row row--near">
            <span class="clip small muted grow" title={one.name}>
              {one.name}
            </span>
            <IconButton
              icon="left"
              label={say("photographs-left", { photograph })}
              disabled={!earlier}
              onClick={() => earlier?.()}
            />
            <IconButton
              icon="right"
              label={say("photographs-right", { photograph })}
              disabled={!later}
              onClick={() => later?.()}
            />
            <IconButton icon="close" label={say("photographs-remove", { photograph })} onClick={remove} />
          </div>
        </>
      ) : (
        <p>{photograph}</p>
      )}
    </li>
  );
}

/** What can be done with the photographs; every change is sent at once. */
function usePhotographs(
  where: { survey_id: number },
  all: Photograph[],
  set: (change: (now: Photograph[]) => Photograph[]) => void,
  reload: () => Promise<void>,
) {
  const sending = useOneByOne(async (body) => {
    const added = await api.write("POST /surveys/{survey_id}/photographs", where, { body });
    set((now) => [...now, added]);
  });
  const run = async (work: () => Promise<unknown>) => {
    await work().catch(toastProblem);
    await reload();
  };
  return {
    ...sending,
    caption: (one: Photograph, text: string) =>
      run(() =>
        api.write(
          "PUT /photographs/{photograph_id}",
          { photograph_id: one.id },
          { body: { caption: text, version: one.version } },
        ),
      ),
    move: (from: number, to: number) => {
      const ids = all.map((one) => one.id);
      ids.splice(to, 0, ...ids.splice(from, 1));
      return run(() => api.write("PUT /surveys/{survey_id}/photographs/order", where, { body: { ids } }));
    },
    remove: (one: Photograph) =>
      run(async () => {
        await api.write("DELETE /photographs/{photograph_id}", {
          photograph_id: one.id,
          version: one.version,
        });
        const back = () =>
          run(() => api.write("POST /photographs/{photograph_id}/restore", { photograph_id: one.id }));
        toast(say("photographs-removed", { photograph: one.caption || one.name }), {
          action: { label: say("command-undo"), run: back },
        });
      }),
  };
}
