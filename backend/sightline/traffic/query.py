"""Figures of an archive: DuckDB over its Parquet, one site at a time, so that memory holds one site's time.

A vehicle belongs to the interval in which its front reached camera 1. Flow: vehicles, measured or not, over
the time that was watched; occupancy: the share of that time in which a vehicle stood before camera 1; both
only where at least half of the interval was watched. Time mean speed: the mean over vehicles; space mean
speed: the harmonic mean, as a stretch of road shows it (Wardrop 1952). Percentiles: Hyndman and Fan's type 8,
without bias of the median, none of fewer speeds than its 95 % interval needs, as everywhere in Sightline. u
of the means: what neither exceeds, whatever the vehicles share: the mean of their own u, or that of u / v
squared times the square of the space mean speed (JCGM 100:2008, 5.2.2), the larger. A vehicle that stands
occupies every interval in which it does; where nobody saw it leave, occupancy is not told from its front to
the end of its recording (who comes later may have passed beside it). Where one still stood when a recording
ended, it is not told of the next one that begins within a minute, which took it for the road, nor of those
after it until another has driven through. Of another whose rear nobody saw it is not told to the first front
after it was given up. One of unknown lane may stand in any lane. Where segments of one stream overlap, time
and vehicles are those of the first, but for one that its end cut off and the next one saw whole.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from datetime import date, datetime, timedelta
from functools import lru_cache
from pathlib import Path
from typing import Any

import duckdb

from sightline.infra.local_time import zone_of
from sightline.linescan.parts import CUT, STANDS_S, STOOD, STOPPED
from sightline.linescan.traffic import class_names
from sightline.statistics.distributions import too_few_for, vehicles_for_interval
from sightline.traffic.archive import ROUGH_S, SHARED_S, VEHICLES, WATCHED, files_of, sites_of
from sightline.traffic.records import Asked, Site
from sightline.traffic.standing import find_marks

_MEMORY, _THREADS = "1GB", 2
_DAY_MINUTES = 24 * 60
#: A day that clocks make longer has at most three hours more, by the minute.
_LONGER_DAY_CELLS = 180
#: Of an interval, for a flow and an occupancy: they speak of all of it.
LEAST_WATCHED = 0.5
_STOOD, _STOPPED, _CUT = (str(one).replace("'", "''") for one in (STOOD, STOPPED, CUT))
#: Of the classes: every vehicle, and those without a length.
ALL, NO_LENGTH = "all", "length unknown"


class ArchiveTables:
    """An archive's tables for questions. Use it as a context; it holds no lock, for files come whole."""

    def __init__(self, folder: Path) -> None:
        self._folder = folder
        self._db = duckdb.connect(":memory:")
        self._db.execute(
            f"SET memory_limit = '{_MEMORY}'; SET threads = {_THREADS}; SET enable_progress_bar = false;"
            "SET autoinstall_known_extensions = false; SET TimeZone = 'UTC'"
        )

    def __enter__(self) -> ArchiveTables:
        return self

    def __exit__(self, *_error: object) -> None:
        self._db.close()

    def sites(self) -> list[Site]:
        """Every lane of every site, and how much there is of it."""
        return [
            Site(site=site, **row)
            for site in sites_of(self._folder)
            if self._load_site(site, Asked())
            for row in self._fetch_rows(_LANES)
        ]

    def recordings(self, site: str) -> list[tuple[dict[str, Any], list[dict[str, Any]]]]:
        """A site's recordings, each with its vehicles as the archive has them; those `told_before` count
        elsewhere.
        """
        if not self._load_site(site, Asked()):
            return []
        passed: dict[str, list[dict[str, Any]]] = {}
        for row in self._fetch_rows("SELECT * EXCLUDE (passed_at) FROM vehicles ORDER BY passed_at"):
            passed.setdefault(row["recording_sha256"], []).append(row)
        return [(row, passed.get(row["recording_sha256"], [])) for row in self._fetch_rows(_RECORDINGS)]

    def intervals(self, asked: Asked) -> Iterator[dict[str, Any]]:
        """One dictionary an interval, lane and class: `COLUMNS` and the percentiles', rising in time.

        Only intervals that were watched at least in part; `reason` says where that is less than whole, or
        where nothing was measured.
        """
        for site in asked.sites or sites_of(self._folder):
            if self._load_site(site, asked):
                for row in self._fetch_rows(_intervals_sql(asked)):
                    yield _row_of_interval(row, site, asked)

    def _load_site(self, site: str, asked: Asked) -> bool:
        """Put one site's `vehicles` and `watched` for queries, of recordings on the days asked for and on the
        day before from their beginnings on; whether there are any. Who stands may have come days before. Who
        stood at the end of an older one is not known: to ask them all takes as long as all days.
        """
        first = asked.first_day and date.fromordinal(max(asked.first_day.toordinal() - 1, 1))
        shown = files_of(self._folder, WATCHED, site, first, asked.last_day)
        if not shown:
            return False
        recordings = {Path(one).name for one in shown}
        watched, passed = (
            [one for one in files if Path(one).name in recordings]
            for files in (
                files_of(self._folder, table, site, None, asked.last_day) for table in (WATCHED, VEHICLES)
            )
        )
        self._db.execute(_WATCHED.format(_read_parquet_sql(watched)))
        read = f"{_read_parquet_sql(passed)} UNION ALL BY NAME {_NOBODY}" if passed else _NOBODY
        self._db.execute(f"CREATE OR REPLACE TEMP VIEW passed AS {read}")
        self._db.execute(_CUT_OFF)
        stood, told = find_marks(self._fetch_rows(_RECORDINGS), self._fetch_rows(_MAY_STAND))
        self._db.execute(_STOOD_BEFORE, [[key for key, _ in stood], [lane for _, lane in stood]])
        self._db.execute(_TOLD, [[key for key, _ in told], [number for _, number in told]])
        self._db.execute(_VEHICLES)
        return True

    def _fetch_rows(self, query: str) -> list[dict[str, Any]]:
        result = self._db.execute(query)
        names = [one[0] for one in result.description or ()]
        return [dict(zip(names, row, strict=True)) for row in result.fetchall()]


#: Of an interval's row, before and after the percentiles.
COLUMNS = (
    "site",
    "lane",
    "class",
    "from",
    "minutes",
    "watched_s",
    "vehicles",
    "measured",
    "flow_per_hour",
    "occupancy_ratio",
    "mean_length_m",
    "median_time_gap_s",
    "time_mean_speed_mps",
    "space_mean_speed_mps",
    "u_mean_speed_mps",
)


def percentile_column(percent: float) -> str:
    """p85_speed_mps of 85."""
    return f"p{percent:g}_speed_mps"


def columns_of(asked: Asked) -> list[str]:
    """The columns of an interval's row, in order."""
    return [*COLUMNS, *map(percentile_column, asked.percents), "reason"]


def classes_of(limits_m: Sequence[float]) -> list[str]:
    """Names of the classes that rising limits part, and of no length: to 6 m, above 6 m, length unknown."""
    return [*class_names(limits_m), NO_LENGTH] if limits_m else []


_NOBODY = """
SELECT NULL::DATE AS day, NULL::VARCHAR AS lane, NULL::VARCHAR AS status, NULL::DOUBLE AS since_midnight_s,
  NULL::DOUBLE AS occupied_s, NULL::DOUBLE AS speed_mps, NULL::DOUBLE AS u_speed_mps,
  NULL::DOUBLE AS length_m, NULL::DOUBLE AS time_gap_s, NULL::DOUBLE AS front_line_1,
  NULL::INTEGER AS number, false AS told_before, NULL::TIMESTAMPTZ AS passed_at, NULL::VARCHAR AS reason,
  NULL::VARCHAR AS direction, NULL::DOUBLE AS rear_s, NULL::VARCHAR AS recording_sha256 WHERE false
"""

#: Where segments of a stream overlap, the first one watched.
_WATCHED = """
CREATE OR REPLACE TEMP TABLE watched AS
SELECT * EXCLUDE (before_s) REPLACE (if(before_s - from_s > 0.001, before_s, from_s) AS from_s)
FROM (SELECT *, max(epoch(midnight_at) + to_s) OVER (PARTITION BY lane ORDER BY start_at, day
  ROWS BETWEEN UNBOUNDED PRECEDING AND 1 PRECEDING) - epoch(midnight_at) AS before_s FROM ({}))
"""
_LANES = """
WITH lanes AS (
  SELECT lane, any_value(zone) AS zone, count(DISTINCT recording_sha256) AS recordings,
    min(day) AS first_day, max(day) AS last_day, count(DISTINCT day) AS days, sum(to_s - from_s) AS watched_s
  FROM watched GROUP BY lane
), passed AS (
  SELECT lane, count(*) AS vehicles, count(*) FILTER (status = 'ok') AS measured
  FROM vehicles WHERE NOT told_before GROUP BY lane
)
SELECT lanes.*, coalesce(vehicles, 0) AS vehicles, coalesce(measured, 0) AS measured
FROM lanes LEFT JOIN passed USING (lane) ORDER BY lane
"""
#: Of each recording its first stretch of time, how long it is, and its lanes.
_RECORDINGS = """
SELECT recording_sha256, any_value(watched) AS first, list(DISTINCT lane) AS lanes,
  max(epoch(midnight_at) + to_s) - epoch(any_value(start_at)) AS watched_s
FROM watched GROUP BY recording_sha256 ORDER BY any_value(start_at), recording_sha256
"""
#: Who was cut by the end of a segment, told of the next one where that had begun by then.
_CUT_OFF = f"""
CREATE OR REPLACE TEMP TABLE days AS
SELECT day, any_value(day_s) AS day_s, epoch(any_value(midnight_at)) AS begin_s FROM watched GROUP BY day;
CREATE OR REPLACE TEMP TABLE ends AS
SELECT recording_sha256, lane, any_value(start_at) AS start_at, min(begin_s + from_s) AS first_s,
  max(begin_s + to_s) AS end_s, count(*) OVER (PARTITION BY recording_sha256) > 1 AS has_lanes
FROM watched JOIN days USING (day) GROUP BY recording_sha256, lane;
CREATE OR REPLACE TEMP TABLE cut AS
SELECT passed.recording_sha256, number, passed.lane, epoch(passed_at) AS passed_s,
  later.recording_sha256 AS told_in
FROM passed JOIN ends USING (recording_sha256, lane)
JOIN ends AS later ON passed.lane IN (later.lane, '') AND later.start_at > ends.start_at
  AND epoch(passed_at) - epoch(later.start_at) BETWEEN 0 AND {SHARED_S}
WHERE reason = '{_CUT}' AND front_line_1 > 0
"""
#: Whom `find_who_stood` asks for: who is in view where a recording begins, and of those alike the last.
_MAY_STAND = f"""
SELECT recording_sha256, lane, direction, reason, status = 'ok' AND speed_mps IS NOT NULL AS measured,
  if(front_line_1 <= 0, number, NULL) AS in_view, any_value(number) AS number,
  min(front_line_1) AS front_line_1, max(rear_s) AS rear_s
FROM passed WHERE front_line_1 <= 0 OR measured OR reason IN ('{_STOOD}', '{_STOPPED}')
GROUP BY recording_sha256, lane, direction, reason, measured, in_view
"""
_STOOD_BEFORE = """
CREATE OR REPLACE TEMP TABLE stood_before AS
SELECT unnest($1::VARCHAR[]) AS recording_sha256, unnest($2::VARCHAR[]) AS lane
"""
_TOLD = """
CREATE OR REPLACE TEMP TABLE told AS
SELECT unnest($1::VARCHAR[]) AS recording_sha256, unnest($2::INTEGER[]) AS number
UNION SELECT recording_sha256, number FROM cut
"""
#: Who came while another segment watched was told of that one.
_VEHICLES = f"""
CREATE OR REPLACE TEMP VIEW vehicles AS
SELECT * EXCLUDE (start_at, first_s, end_s, has_lanes) REPLACE (
  coalesce(told_before, false) OR epoch(passed_at) < least(first_s - 0.001, (
    SELECT min(passed_s) - {ROUGH_S} FROM cut
    WHERE told_in = passed.recording_sha256 AND cut.lane IN (passed.lane, '')))
  OR (recording_sha256, number) IN (SELECT (told.recording_sha256, told.number) FROM told) AS told_before)
FROM passed JOIN ends USING (recording_sha256, lane)
"""


def _read_parquet_sql(files: Sequence[str]) -> str:
    named = ", ".join("'" + one.replace("'", "''") + "'" for one in files)
    return (
        f"SELECT * FROM read_parquet([{named}], hive_partitioning = true, "
        "union_by_name = true, hive_types = {'site': VARCHAR, 'day': DATE})"
    )


def _intervals_sql(asked: Asked) -> str:
    """The intervals of one site that were watched, each with all its classes; `cell` counts from day 0 on."""
    step, of_day = 60 * asked.minutes, _DAY_MINUTES // asked.minutes + _LONGER_DAY_CELLS
    begins = f"(day - DATE '1970-01-01') * {of_day}"
    classes = len(classes_of(asked.limits_m)) + 1
    return f"""
    WITH cut AS (
      SELECT *, unnest(range(floor(from_s / {step})::BIGINT, ceil(to_s / {step})::BIGINT)) AS nth FROM watched
      WHERE day >= DATE '{asked.first_day or date.min}'
    ), cells AS (
      SELECT lane, {begins} + nth AS cell, any_value(nth) AS nth,
        any_value(least({step}.0, day_s - nth * {step})) AS length_s,
        sum(least(to_s, (nth + 1) * {step}) - greatest(from_s, nth * {step})) AS watched_s,
        any_value(midnight_at) AS midnight_at, any_value(zone) AS zone
      FROM cut GROUP BY lane, cell
    ), passed AS (
      SELECT lane, length_m, time_gap_s, speed_mps, u_speed_mps, {_kind_sql(asked.limits_m)} AS kind,
        {begins} + least(floor(since_midnight_s / {step}), ceil(day_s / {step}) - 1)::BIGINT AS cell
      FROM vehicles JOIN days USING (day)
      WHERE day >= DATE '{asked.first_day or date.min}' AND NOT told_before
    ), came AS (
      SELECT *, since_midnight_s + occupied_s AS until_s FROM vehicles JOIN days USING (day)
    ), standing AS (
      SELECT lane, day, length_m, since_midnight_s AS from_s, least(until_s, day_s) AS until_s
      FROM came WHERE occupied_s > 0
      UNION ALL
      SELECT lane, on_day.day, length_m, 0, least(until_s - on_day.begin_s + came.begin_s, on_day.day_s)
      FROM came JOIN days AS on_day ON on_day.begin_s > came.begin_s
        AND on_day.begin_s < came.begin_s + until_s
      WHERE until_s > came.day_s
    ), in_days AS (
      SELECT lane, day, length_m, until_s, greatest(from_s, coalesce(max(until_s) OVER (PARTITION BY lane, day
        ORDER BY from_s, until_s ROWS BETWEEN UNBOUNDED PRECEDING AND 1 PRECEDING), 0)) AS from_s
      FROM standing WHERE day >= DATE '{asked.first_day or date.min}'
    ), in_cells AS (
      SELECT *, unnest(range(floor(from_s / {step})::BIGINT, ceil(until_s / {step})::BIGINT)) AS nth,
      FROM in_days WHERE from_s < until_s
    ), parts AS (
      SELECT lane, {begins} + nth AS cell, {_kind_sql(asked.limits_m)} AS kind,
        least(until_s, (nth + 1) * {step}) - greatest(from_s, nth * {step}) AS part_s
      FROM in_cells
    ), occupied AS (
      SELECT lane, cell, kind, sum(part_s) AS occupied_s FROM parts GROUP BY lane, cell, kind
    ), strays AS (
      SELECT came.* REPLACE (ends.lane AS lane) FROM came JOIN ends USING (recording_sha256)
      WHERE occupied_s IS NULL AND came.lane = '' AND has_lanes AND ends.lane <> ''
    ), stood AS (
      SELECT lane, recording_sha256, length_m, begin_s + since_midnight_s AS since_s,
        if(reason = '{_STOOD}', 'inf'::DOUBLE, NULL) AS stands_s,
        coalesce(min(begin_s + since_midnight_s) OVER (PARTITION BY lane ORDER BY begin_s + since_midnight_s
          RANGE BETWEEN {STANDS_S} FOLLOWING AND UNBOUNDED FOLLOWING), 'inf'::DOUBLE) AS next_s
      FROM (FROM came UNION ALL FROM strays) QUALIFY occupied_s IS NULL
    ), rear_unseen AS (
      SELECT lane, day, length_m, greatest(since_s - begin_s, 0) AS from_s,
        least(coalesce(stands_s, next_s) - begin_s, end_s - begin_s, day_s) AS until_s
      FROM stood JOIN ends USING (recording_sha256, lane)
      JOIN days ON since_s < begin_s + day_s AND least(coalesce(stands_s, next_s), end_s) > begin_s
      UNION ALL
      SELECT lane, days.day, NULL AS length_m, greatest(first_s - days.begin_s, 0) AS from_s,
        least(end_s - days.begin_s, days.day_s) AS until_s
      FROM stood_before JOIN ends USING (recording_sha256, lane)
      JOIN days ON first_s < days.begin_s + days.day_s AND end_s > days.begin_s
    ), unsure_cells AS (
      SELECT *, unnest(range(floor(from_s / {step})::BIGINT, ceil(until_s / {step})::BIGINT)) AS nth
      FROM rear_unseen
    ), unsure AS (
      SELECT DISTINCT lane, {begins} + nth AS cell, {_kind_sql(asked.limits_m)} AS kind, true AS unsure
      FROM unsure_cells
    ), counted AS (
      SELECT lane, cell, kind, count(*) AS vehicles, count(speed_mps) AS n,
        avg(length_m) AS mean_length_m,
        median(time_gap_s) FILTER (WHERE speed_mps IS NOT NULL) AS median_time_gap_s,
        avg(speed_mps) AS time_mean_speed_mps, 1 / avg(1 / speed_mps) AS space_mean_speed_mps,
        greatest(avg(u_speed_mps), avg(u_speed_mps / speed_mps**2) / avg(1 / speed_mps)**2)
          AS u_mean_speed_mps,
        list(speed_mps ORDER BY speed_mps) FILTER (speed_mps IS NOT NULL) AS rising
      FROM passed GROUP BY lane, cell, kind
    ), kinds AS (SELECT unnest(range({classes})) AS kind)
    SELECT * EXCLUDE (rising){"".join(map(_percentile_sql, asked.percents))}
    FROM cells CROSS JOIN kinds LEFT JOIN counted USING (lane, cell, kind)
    LEFT JOIN occupied USING (lane, cell, kind) LEFT JOIN unsure USING (lane, cell, kind)
    ORDER BY lane, cell, kind
    """


def _kind_sql(limits_m: Sequence[float]) -> str:
    """The place of a vehicle's class, by the rule of `class_names`, and once more 0, the place of all."""
    if not limits_m:
        return "0::BIGINT"
    cases = " ".join(f"WHEN length_m <= {limit!r} THEN {at}" for at, limit in enumerate(limits_m, 1))
    last = len(limits_m) + 1
    return f"unnest([0, CASE WHEN length_m IS NULL THEN {last + 1} {cases} ELSE {last} END])"


def _percentile_sql(percent: float) -> str:
    """After a comma the percentile: between the two speeds beside place n p + (p + 1) / 3 (type 8); none of
    too few.
    """
    p = percent / 100
    at = f"least(n, greatest(1, (n + 1 / 3.0) * {p!r} + 1 / 3.0))"
    low, high = f"rising[floor({at})::BIGINT]", f"rising[ceil({at})::BIGINT]"
    value, needs = f"{low} + ({at} - floor({at})) * ({high} - {low})", vehicles_for_interval(percent)
    return f', CASE WHEN n >= {needs} THEN {value} END AS "{percentile_column(percent)}"'


def _row_of_interval(row: dict[str, Any], site: str, asked: Asked) -> dict[str, Any]:
    """A row of the query as it is told: rates, the local time, the reason."""
    watched_s, vehicles = row["watched_s"], row["vehicles"] or 0
    enough = watched_s >= LEAST_WATCHED * row["length_s"]
    begins = row["nth"] * 60 * asked.minutes
    told = {
        **row,
        "site": site,
        "class": (ALL, *classes_of(asked.limits_m))[row["kind"]],
        "from": _local_text(row["midnight_at"], row["zone"], begins),
        "minutes": row["length_s"] / 60,
        "vehicles": vehicles,
        "measured": row["n"] or 0,
        "flow_per_hour": 3600 * vehicles / watched_s if enough else None,
        "occupancy_ratio": (row["occupied_s"] or 0.0) / watched_s if enough and not row["unsure"] else None,
        "reason": _reason(row, vehicles, enough, asked.percents),
    }
    return {name: told[name] for name in columns_of(asked)}


def _reason(row: dict[str, Any], vehicles: int, enough: bool, percents: Sequence[float]) -> str | None:
    reasons = []
    if row["watched_s"] < row["length_s"] - 1e-6:
        rest = "" if enough else ", too little for a flow"
        reasons.append(f"watched for {row['watched_s']:.0f} of {row['length_s']:.0f} s{rest}")
    if not vehicles:
        reasons.append("no vehicle")
    elif not row["n"]:
        reasons.append("no speed could be measured")
    else:
        few = [one for one in percents if row[percentile_column(one)] is None]
        reasons += [str(too_few_for(one, row["n"])) for one in few]
    if row["unsure"]:
        reasons.append("the rear of a vehicle that stood was not seen")
    return "; ".join(reasons) or None


@lru_cache(maxsize=100_000)
def _local_text(midnight: datetime, zone: str, seconds: int) -> str:
    return (midnight + timedelta(seconds=seconds)).astimezone(zone_of(zone)).isoformat(timespec="minutes")
