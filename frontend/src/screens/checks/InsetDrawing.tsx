/** The road seen along the traffic: the ray to a target behind the side plane meets that plane at another height. */
import { say } from "../../core/messages";

// 130 px a metre upwards, 90 px a metre across: camera 1.5 m up, side plane at 3 m, target 0.9 m up, 1.2 m behind
const ROAD = 284;
const CAMERA = { x: 64, y: 89 };
const PLANE = 334;
const TARGET = { x: 442, y: 167 };
const READ = { x: PLANE, y: 144.7 };

export function InsetDrawing() {
  return (
    <svg
      class="inset-drawing"
      viewBox="0 0 620 344"
      role="img"
      aria-label={say("checks-drawing")}
      data-testid="inset-drawing"
    >
      <path
        class="inset-drawing__car"
        d="M337 262Q337 204 344 200L352 190Q372 126 384 120Q440 108 496 120Q508 126 526 190L534 200Q541 204 541 262Z"
      />
      <path class="inset-drawing__tyre" d={`M${PLANE + 1} 240h22v44h-22zM520 240h22v44h-22z`} />
      <path class="inset-drawing__road" d={`M16 ${ROAD}H604`} />
      <path class="inset-drawing__plane" d={`M${PLANE} 60V${ROAD}`} />
      <path class="inset-drawing__ray" d={`M${CAMERA.x} ${CAMERA.y}L${TARGET.x} ${TARGET.y}`} />
      <path class="inset-drawing__level" d={`M${READ.x} ${READ.y}H576M${TARGET.x} ${TARGET.y}H576`} />
      <path
        class="inset-drawing__measure"
        d={`M${CAMERA.x} 304H${PLANE}M${CAMERA.x} 299v10M${PLANE} 299v10M${PLANE} 304H${TARGET.x}M${TARGET.x} 299v10M${CAMERA.x} 104V${ROAD}M572 ${READ.y}V${TARGET.y}`}
      />
      <path class="inset-drawing__guide" d={`M${TARGET.x} ${TARGET.y}V300`} />
      <path
        class="inset-drawing__camera"
        d={`M${CAMERA.x - 30} ${CAMERA.y - 11}h22v22h-22zM${CAMERA.x - 8} ${CAMERA.y - 6}l9 -4v20l-9 -4z`}
      />
      <path class="inset-drawing__contact" d={`M${PLANE} ${ROAD + 1}l7 11h-14z`} />
      <circle class="inset-drawing__read" cx={READ.x} cy={READ.y} r="5" />
      <circle class="inset-drawing__target" cx={TARGET.x} cy={TARGET.y} r="6" />
      <text x={CAMERA.x - 34} y={CAMERA.y - 20}>
        {say("checks-drawing-camera")}
      </text>
      <text x={CAMERA.x + 8} y="200">
        H<tspan dy="4">c</tspan>
      </text>
      <text x={PLANE} y="50" text-anchor="middle">
        {say("checks-drawing-side-plane")}
      </text>
      <text x={(CAMERA.x + PLANE) / 2} y="324" text-anchor="middle">
        D
      </text>
      <text x={(PLANE + TARGET.x) / 2} y="324" text-anchor="middle">
        {say("checks-drawing-inset")}
      </text>
      <text x={READ.x - 10} y={READ.y + 22} text-anchor="end">
        {say("checks-drawing-read")}
      </text>
      <text x={TARGET.x} y={TARGET.y + 24} text-anchor="middle" class="inset-drawing__inside">
        {say("checks-drawing-target")}
      </text>
      {say("checks-drawing-too-high")
        .split("\n")
        .map((line, i) => (
          <text key={line} x="580" y={(READ.y + TARGET.y) / 2 + 4 + i * 14}>
            {line}
          </text>
        ))}
    </svg>
  );
}
