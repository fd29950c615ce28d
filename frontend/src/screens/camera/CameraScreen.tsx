import { useState } from "preact/hooks";
import { api } from "../../api";
import { Button, Dialog, Empty, Loading, Problem, TextField } from "../../components";
import { query, type ScreenProps, setQuery } from "../../router";
import { useResource } from "../../state/resource";
import { may } from "../../state/session";
import { refreshSurvey } from "../../state/survey";
import type { Camera, CameraDetail } from "../../types";
import { CameraBench } from "./CameraBench";
import "./camera.css";

/** The survey's cameras; one is open. */
export default function CameraScreen({ surveyId }: ScreenProps) {
  const cameras = useResource(
    (signal) => api.get<Camera[]>(`/surveys/${surveyId}/cameras`, { signal }),
    [surveyId],
  );
  const [adding, setAdding] = useState(false);
  const list = cameras.data ?? [];
  const wanted = Number(query.value.get("camera"));
  const open = list.find((camera) => camera.id === wanted) ?? list[0] ?? null;
  const added = async (camera: Camera) => {
    setAdding(false);
    await cameras.reload();
    setQuery({ camera: camera.id });
    await refreshSurvey();
  };
  const canWork = may("operator");
  return (
    <div class="page">
      <header class="page__head">
        <div>
          <h1>Camera</h1>
          <p class="page__lead">
            A body and lens at one setting of zoom and focus. Calibrating it tells how the lens bends the
            picture, and how well that is known.
          </p>
        </div>
        {canWork && list.length > 0 && (
          <Button icon="add" onClick={() => setAdding(true)}>
            Another camera
          </Button>
        )}
      </header>
      <Problem error={cameras.error} again={cameras.reload} />
      {!cameras.data && cameras.loading && <Loading what="cameras" />}
      {cameras.data && list.length === 0 && (
        <div class="panel">
          <Empty
            title="No camera yet"
            actions={
              canWork && (
                <Button kind="primary" icon="add" onClick={() => setAdding(true)}>
                  Add the camera
                </Button>
              )
            }
          >
            <p>
              Name the camera that filmed this site. Then drop in some fifteen pictures of a checkerboard,
              taken with it at the same zoom and focus, or a file with its calibration from another tool.
            </p>
          </Empty>
        </div>
      )}
      {list.length > 1 && open && (
        <nav class="tabs" aria-label="Cameras">
          {list.map((camera) => (
            <button
              key={camera.id}
              type="button"
              class="tabs__tab"
              aria-current={camera.id === open.id ? "true" : undefined}
              onClick={() => setQuery({ camera: camera.id })}
            >
              {camera.name}
            </button>
          ))}
        </nav>
      )}
      {open && <OpenCamera key={open.id} id={open.id} surveyId={surveyId} />}
      {adding && (
        <AddCamera surveyId={surveyId} count={list.length} close={() => setAdding(false)} added={added} />
      )}
    </div>
  );
}

function OpenCamera({ id, surveyId }: { id: number; surveyId: number }) {
  const camera = useResource((signal) => api.get<CameraDetail>(`/cameras/${id}`, { signal }), [id]);
  if (!camera.data) {
    return camera.error ? (
      <Problem error={camera.error} again={camera.reload} />
    ) : (
      <Loading what="the camera" />
    );
  }
  return <CameraBench camera={camera.data} surveyId={surveyId} reload={camera.reload} set={camera.set} />;
}

interface AddProps {
  surveyId: number;
  count: number;
  close: () => void;
  added: (camera: Camera) => Promise<void>;
}

function AddCamera({ surveyId, count, close, added }: AddProps) {
  const [name, setName] = useState(count === 0 ? "Camera 1" : `Camera ${count + 1}`);
  const [notes, setNotes] = useState("");
  const [problem, setProblem] = useState<unknown>(null);
  const [busy, setBusy] = useState(false);
  const submit = async (event: Event) => {
    event.preventDefault();
    if (!name.trim()) return;
    setBusy(true);
    setProblem(null);
    try {
      await added(await api.post<Camera>(`/surveys/${surveyId}/cameras`, { name: name.trim(), notes }));
    } catch (error) {
      setProblem(error);
      setBusy(false);
    }
  };
  return (
    <Dialog
      title="Add a camera"
      onClose={close}
      actions={
        <>
          <Button onClick={close}>Cancel</Button>
          <Button
            kind="primary"
            busy={busy}
            disabled={!name.trim()}
            onClick={() => document.querySelector<HTMLFormElement>("#add-camera")?.requestSubmit()}
          >
            Add
          </Button>
        </>
      }
    >
      <form id="add-camera" class="stack" onSubmit={submit} noValidate>
        <TextField
          label="Name"
          value={name}
          onInput={setName}
          problem={name.trim() ? null : "A camera needs a name."}
        />
        <TextField
          label="Notes"
          value={notes}
          onInput={setNotes}
          rows={2}
          hint="Body, lens, zoom and focus setting: what must stay the same for the calibration to hold."
        />
        <Problem error={problem} />
        <button type="submit" hidden />
      </form>
    </Dialog>
  );
}
