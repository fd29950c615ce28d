import { useState } from "preact/hooks";
import { Button, Empty, Loaded, Notice, PageHead } from "../../components";
import { asked, query, setQuery } from "../../core/address";
import { say } from "../../core/messages";
import type { ScreenProps } from "../../core/places";
import { useAsked } from "../../core/resource";
import { may } from "../../core/session";
import { refreshSurvey } from "../../core/survey";
import type { Camera } from "../../core/types";
import { AddCamera } from "./AddCamera";
import { CameraBench } from "./CameraBench";
import { TakeCamera } from "./TakeCamera";
import "./camera.css";

export default function CameraScreen({ surveyId }: ScreenProps) {
  const cameras = useAsked("GET /surveys/{survey_id}/cameras", { survey_id: surveyId });
  const [adding, setAdding] = useState(false);
  const [taking, setTaking] = useState(false);
  const list = cameras.data ?? [];
  // the address is followed, so that a link to another camera opens it
  void query.value;
  const wanted = asked("camera");
  const open = list.find((camera) => camera.id === wanted) ?? list[0] ?? null;
  const added = async (camera: Camera) => {
    setAdding(false);
    setTaking(false);
    await cameras.reload();
    setQuery({ camera: camera.id });
    await refreshSurvey();
  };
  const canWork = may("operator");
  return (
    <div class="page">
      <PageHead says="page-camera" lead={say("camera-lead")}>
        {canWork && list.length > 0 && (
          <div class="row">
            <Button says="camera-take-open" onClick={() => setTaking(true)} />
            <Button says="camera-another" icon="add" onClick={() => setAdding(true)} />
          </div>
        )}
      </PageHead>
      <Loaded of={cameras} what={say("camera-loading-all")} />
      {wanted !== null && open && open.id !== wanted && (
        <Notice kind="warning">{say("address-elsewhere", { what: "camera" })}</Notice>
      )}
      {cameras.data && list.length === 0 && (
        <Empty
          panel
          says="camera-none-title"
          why="camera-none"
          actions={
            canWork && (
              <>
                <Button says="camera-add-first" kind="primary" icon="add" onClick={() => setAdding(true)} />
                <Button says="camera-take-open" onClick={() => setTaking(true)} />
              </>
            )
          }
        />
      )}
      {list.length > 1 && open && (
        <nav class="page-tabs" aria-label={say("camera-list")}>
          {list.map((camera) => (
            <button
              key={camera.id}
              type="button"
              aria-current={camera.id === open.id ? "true" : undefined}
              onClick={() => setQuery({ camera: camera.id })}
            >
              {camera.name}
            </button>
          ))}
        </nav>
      )}
      {list.length === 1 && open && <h2 data-testid="camera-name">{open.name}</h2>}
      {open && <OpenCamera key={open.id} id={open.id} surveyId={surveyId} />}
      {adding && (
        <AddCamera surveyId={surveyId} count={list.length} close={() => setAdding(false)} added={added} />
      )}
      {taking && <TakeCamera surveyId={surveyId} close={() => setTaking(false)} added={added} />}
    </div>
  );
}

function OpenCamera({ id, surveyId }: { id: number; surveyId: number }) {
  const camera = useAsked("GET /cameras/{camera_id}", { camera_id: id });
  if (!camera.data) {
    return <Loaded of={camera} what={say("camera-loading")} />;
  }
  return <CameraBench camera={camera.data} surveyId={surveyId} reload={camera.reload} set={camera.set} />;
}
