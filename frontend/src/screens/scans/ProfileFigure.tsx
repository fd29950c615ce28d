/** Speed along the vehicle with the fitted motion, and what is left over; blocks outside the fit are hollow. */
import { say, withUnit } from "../../core/messages";
import type { ScanVehicleDetail } from "../../core/types";
import { speedScale } from "../../core/units";
import { PlotFigure } from "../../parts/figures/PlotFigure";
import { readable, readRows } from "../../parts/figures/reading";

type Row = { time_s: number; speed: number; fitted: number; used: boolean };
const MEASURED = { x: (row: Row) => row.time_s, y: (row: Row) => row.speed };
const FITTED = { x: MEASURED.x, y: (row: Row) => row.fitted };

export function ProfileFigure({ detail }: { detail: ScanVehicleDetail }) {
  const profile = detail.profile;
  const [by, unit] = speedScale();
  const rows =
    profile?.time_s.map((time_s, n) => ({
      time_s,
      speed: (profile.speed_mps[n] ?? 0) * by,
      fitted: (profile.fitted_mps[n] ?? 0) * by,
      used: profile.used[n] ?? false,
    })) ?? [];
  const fitted = rows.map((row) => row.fitted);
  const near = Math.max(
    ...rows.filter((row) => row.used).map((row) => Math.abs(row.speed - row.fitted)),
    0.02,
  );
  const low = Math.min(...fitted) - 1.6 * near;
  const high = Math.max(...fitted) + 1.6 * near;
  const within = rows.filter((row) => row.speed >= low && row.speed <= high);
  const beyond = rows.length - within.length;
  const used = within.filter((row) => row.used);
  const leftOut = within.filter((row) => !row.used);
  return (
    <PlotFigure
      name={`speed-profile-${detail.vehicle.number}`}
      title={say("scan-profile-title")}
      says={say("scan-profile-says", { count: rows.length, vehicle: String(detail.vehicle.number) })}
      data={profile}
      reason={profile === null ? say("scan-profile-none") : null}
      legend={[
        { word: say("scan-profile-fitted") },
        { word: say("scan-profile-used"), dot: "circle" },
        { word: say("scan-profile-left-out"), dot: "triangle", faint: true },
      ]}
      note={beyond > 0 ? say("scan-profile-beyond", { count: beyond }) : say("scan-profile-note")}
      options={(plot) => ({
        height: 220,
        x: { label: say("scan-profile-x") },
        y: { label: withUnit(say("scan-head-speed"), unit), domain: [low, high] },
        marks: [
          readable(
            plot.line(rows, { ...FITTED, strokeWidth: 2 }),
            readRows(rows, FITTED, "line", say("scan-profile-fitted")),
          ),
          readable(
            plot.dot(used, { ...MEASURED, r: 2.4, stroke: "currentColor" }),
            readRows(used, MEASURED, "points", say("scan-profile-used")),
          ),
          plot.dot(leftOut, { ...MEASURED, r: 2.5, symbol: "triangle", stroke: "var(--ink-3)" }),
        ],
      })}
      table={() => ({
        columns: ["line_1", "time_s", "speed_mps", "fitted_mps", "residual_mps", "used"],
        rows:
          profile?.line_1.map((line, n) => [
            line,
            profile.time_s[n] ?? null,
            profile.speed_mps[n] ?? null,
            profile.fitted_mps[n] ?? null,
            profile.residual_mps[n] ?? null,
            profile.used[n] ? 1 : 0,
          ]) ?? [],
      })}
    />
  );
}
