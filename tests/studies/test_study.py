"""`sightline study`: packages alone become figures with total intervals, and what does not fit is refused."""

import hashlib
import json
from collections.abc import Callable
from pathlib import Path

import duckdb
import numpy as np
import pyarrow as pa
import pyarrow.parquet as pq
import pytest

from sightline.cli import main
from tests.export.test_export_package import ground, package, worked
from tests.support.studies import CLASS_M, Invented, invent

__all__ = ["ground", "package", "worked"]
MOVED_M = (-0.02, 0.0, 0.01, 0.02)
FLEET = "category,share\nhatchback,0.3\nsuv,0.3\nvan,0.4\n"


@pytest.fixture
def four(tmp_path: Path) -> list[str]:
    """Packages of four sites."""
    surveys = [Invented(f"survey {n}", f"site {n}", 150, moved_m=moved) for n, moved in enumerate(MOVED_M)]
    return [str(invent(tmp_path / f"{one.site}", one, n)) for n, one in enumerate(surveys)]


def studied(capsys: pytest.CaptureFixture[str], *arguments: str) -> dict[str, list[dict[str, float]]]:
    assert main(["study", *arguments, "--quick", "--json"]) == 0, capsys.readouterr().err
    return json.loads(capsys.readouterr().out)


def of(told: dict[str, list[dict[str, float]]], figure: str, target: str = "roof") -> dict[str, float]:
    rows = [one for one in told["figures"] if one["target"] == target]
    return next(one for one in rows if f"P{one.get('percent') or 0:g}" == figure or one["figure"] == figure)


def test_four_packages_are_one_study(
    four: list[str], tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    told = studied(capsys, *four, "-o", str(tmp_path / "study"))
    assert (told["heights"], told["vehicles"]) == (1800, 600)
    mean = of(told, "mean")
    truth = float(np.dot([0.55, 0.35, 0.10], list(CLASS_M.values())))
    assert mean["low_m"] < truth < mean["high_m"]
    # four sites say more of themselves than of roads: wider than 600 vehicles drawn one by one
    assert mean["design_effect"] > 1.5 and mean["effective_n"] < 400
    assert mean["high_m"] - mean["low_m"] > 2 * 1.96 * 0.2 / np.sqrt(600)
    tenth = of(told, "P10")
    assert tenth["raw_m"] < tenth["value_m"] < mean["value_m"]  # random error widened the tails
    shares = {one["category"]: one["share"] for one in told["classes"] if one["group"] == "all"}
    assert sum(shares.values()) == pytest.approx(1.0)
    plan = [one for one in told["plan"] if one["target"] == "roof"]
    needed = [one["vehicles_each"] for one in plan if one["vehicles_each"] is not None]
    assert needed == sorted(needed, reverse=True)  # more sites need fewer vehicles each
    assert all(one["U95_m"] <= 0.010 for one in plan if one["vehicles_each"] is not None)
    for name in ("figures", "errors", "classes", "plan", "packages"):
        written = pq.read_table(tmp_path / "study" / "parquet" / f"{name}.parquet")
        assert written.num_rows == len(told[name])


def test_only_heights_in_the_sample_count_and_it_is_said(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    surveys = [Invented(f"survey {n}", f"site {n}", 150, sample_one_in=1 + n) for n in range(2)]
    places = [str(invent(tmp_path / one.site, one, n)) for n, one in enumerate(surveys)]
    assert main(["study", *places, "--quick", "--json", "-o", str(tmp_path / "study")]) == 0
    told = json.loads(capsys.readouterr().out)
    assert (told["heights"], told["vehicles"]) == (450 + 225, 150 + 75)
    assert [(one["counted"], one["out_of_sample"]) for one in told["packages"]] == [(450, 0), (225, 225)]
    assert any("225 accepted heights are of vehicles outside" in note for note in told["notes"])


def test_packages_with_other_columns_beside_those_that_are_read_are_one_study(
    four: list[str], tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """A version that tells more, or less, of what no figure is made of; a lacking column that one is."""
    alike = studied(capsys, *four, "-o", str(tmp_path / "alike"))
    for n, name in ((1, "operator_id"), (3, "clicked_at")):
        changed(four[n], "measurements", lambda rows, name=name: rows.append_column(name, rows["id"]))
    changed(four[2], "vehicles", lambda rows: rows.drop_columns(["discarded"]))
    found = studied(capsys, *four, "-o", str(tmp_path / "study"))
    assert (found["heights"], found["figures"]) == (1800, alike["figures"])
    changed(four[2], "vehicles", lambda rows: rows.drop_columns(["counts"]))
    assert main(["study", *four, "--quick", "-o", str(tmp_path / "other")]) == 2
    assert "(version test) lacks the column counts of vehicles.csv" in capsys.readouterr().err


def test_the_error_table_is_that_of_the_rows(
    four: list[str], tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    told = studied(capsys, *four, "-o", str(tmp_path / "study"))
    tables = [str(Path(one) / "parquet" / "{}.parquet") for one in four]
    rows = duckdb.sql(
        f"""SELECT m.height_m - v.manufacturer_height_m AS e, v.lighting
        FROM read_parquet({[one.format("measurements") for one in tables]}, filename = true) m
        JOIN read_parquet({[one.format("vehicles") for one in tables]}, filename = true) v
        ON v.id = m.vehicle_id
          AND replace(v.filename, 'vehicles', '') = replace(m.filename, 'measurements', '')
        WHERE m.target = 'roof'"""
    ).fetchnumpy()
    errors = {(one["group"], one["figure"]): one for one in told["errors"]}
    for group in ("overall", "daytime", "low_light"):
        e = rows["e"] if group == "overall" else rows["e"][rows["lighting"] == group]
        assert errors[group, "bias_m"]["value_m"] == pytest.approx(e.mean(), abs=1e-12)
        assert errors[group, "mae_m"]["value_m"] == pytest.approx(np.abs(e).mean(), abs=1e-12)
        assert errors[group, "rmse_m"]["value_m"] == pytest.approx(np.sqrt((e**2).mean()), abs=1e-12)
        assert errors[group, "bias_m"]["n"] == len(e)


def test_weights_bring_the_classes_to_the_fleet(
    four: list[str], tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "fleet.csv").write_text(FLEET)
    told = studied(capsys, *four, "-o", str(tmp_path / "study"), "--weights", str(tmp_path / "fleet.csv"))
    mean = of(told, "mean")
    truth = float(np.dot([0.3, 0.3, 0.4], list(CLASS_M.values())))
    assert mean["low_m"] < truth < mean["high_m"] and mean["weighting_effect"] > 1.5
    # within classes heights vary by 6 cm, sites by 2: the classes' own 20 cm are no longer chance
    assert mean["high_m"] - mean["low_m"] < 0.08
    (tmp_path / "counts.csv").write_text(
        "variable,class,registrations\ncategory,hatchback,300\ncategory,suv,300\ncategory,van,400\n"
        "lighting,daytime,800\nlighting,low_light,200\n"
    )
    raked = studied(capsys, *four, "-o", str(tmp_path / "raked"), "--weights", str(tmp_path / "counts.csv"))
    assert of(raked, "mean")["value_m"] == pytest.approx(mean["value_m"], abs=0.02)


def test_a_site_that_the_fleet_has_nothing_of_counts_for_nothing(
    four: list[str], tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    fleet = "variable,class,share\nsite,site 0,0\nsite,site 1,0.3\nsite,site 2,0.3\nsite,site 3,0.4\n"
    (tmp_path / "fleet.csv").write_text(fleet)
    weights = ["--weights", str(tmp_path / "fleet.csv")]
    told = [studied(capsys, *some, "-o", str(tmp_path / "study"), *weights) for some in (four, four[1:])]
    for figure in ("mean", "P10"):
        assert of(told[0], figure) == of(told[1], figure)


def test_sites_of_a_known_number_narrow_the_interval(
    four: list[str], tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    widths = []
    for there in ("", "5", "4"):
        rows = "".join(f"site {n},all,{there}\n" for n in range(4))
        (tmp_path / "sites.csv").write_text(f"site,stratum,sites_there\n{rows}")
        told = studied(capsys, *four, "-o", str(tmp_path / "study"), "--sites", str(tmp_path / "sites.csv"))
        mean = of(told, "mean")
        widths.append(mean["high_m"] - mean["low_m"])
    assert widths[0] > widths[1] > widths[2] > 2 * 1.96 * 0.1 / np.sqrt(600)


def test_a_real_package_is_verified_whole_first(
    package: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["study", str(package), "-o", str(tmp_path / "study"), "--json"]) == 0
    assert json.loads(capsys.readouterr().out)["heights"] == 2
    text = (package / "tables/measurements.csv").read_text()
    (package / "tables/measurements.csv").write_text(text.replace("1.31", "1.21"))
    assert main(["study", str(package), "-o", str(tmp_path / "other")]) == 2
    said = capsys.readouterr().err
    assert "does not verify" in said and said.count("\n") == 1
    assert not (tmp_path / "other").exists()


def test_a_changed_parquet_is_found_without_computing_anything_again(
    four: list[str], tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = Path(four[2]) / "parquet" / "measurements.parquet"
    table = pq.read_table(path)
    pq.write_table(table.slice(1), path)
    assert main(["study", *four, "-o", str(tmp_path / "study"), "--quick"]) == 2
    assert "parquet/measurements.parquet is not what the package’s seal" in capsys.readouterr().err


def fleet(text: str) -> Callable[[Path, list[str]], list[str]]:
    def make(tmp_path: Path, four: list[str]) -> list[str]:
        (tmp_path / "fleet.csv").write_text(text)
        return [*four, "--weights", str(tmp_path / "fleet.csv")]

    return make


def sites(text: str) -> Callable[[Path, list[str]], list[str]]:
    def make(tmp_path: Path, four: list[str]) -> list[str]:
        (tmp_path / "sites.csv").write_text(text)
        return [*four, "--sites", str(tmp_path / "sites.csv")]

    return make


def invented(**facts: object) -> Callable[[Path, list[str]], list[str]]:
    def make(tmp_path: Path, four: list[str]) -> list[str]:
        one = Invented("another", "elsewhere", 20, **facts)  # type: ignore[arg-type]
        return [*four, str(invent(tmp_path / "another", one))]

    return make


def of_another_version(tmp_path: Path, four: list[str]) -> list[str]:
    one = str(invent(tmp_path / "old", Invented("old", "elsewhere", 20, version="0.0.9")))
    changed(one, "measurements", lambda rows: rows.drop_columns(["u_inset_m"]))
    return [*four, one]


def strange(table: str, column: str) -> Callable[[Path, list[str]], list[str]]:
    """A package in the last of whose rows a column has a word of a later version."""

    def make(tmp_path: Path, four: list[str]) -> list[str]:
        one = str(invent(tmp_path / "new", Invented("new", "elsewhere", 20, version="9.0.0")))

        def change(rows: pa.Table) -> pa.Table:
            words = [*rows[column].to_pylist()[:-1], "hovering"]
            return rows.set_column(rows.column_names.index(column), column, pa.array(words))

        changed(one, table, change)
        return [*four, one]

    return make


def changed(place: str, table: str, change: Callable[[pa.Table], pa.Table]) -> None:
    """Change a table of a package's Parquet and seal it as it then is."""
    path, audit = Path(place) / "parquet" / f"{table}.parquet", Path(place) / "audit.csv"
    old = hashlib.sha256(path.read_bytes()).hexdigest()
    pq.write_table(change(pq.read_table(path)), path)
    audit.write_text(audit.read_text().replace(old, hashlib.sha256(path.read_bytes()).hexdigest()))


BAD: dict[str, tuple[Callable[[Path, list[str]], list[str]], str]] = {
    "shares that do not sum": (fleet("category,share\nhatchback,0.5\nsuv,0.3\n"), "sum to 0.8, not to 1"),
    "fleets of two sizes": (
        fleet("variable,class,registrations\ncategory,suv,100\nlighting,daytime,90\n"),
        "category sums to 100 vehicles and lighting to 90",
    ),
    "a class never seen": (
        fleet("category,share\nhatchback,0.5\nsuv,0.3\nvan,0.1\nlorry,0.1\n"),
        "category lorry, which no survey contains",
    ),
    "a class left out": (fleet("category,share\nhatchback,0.5\nsuv,0.5\n"), "vehicles of category van"),
    "a word that is no class": (
        fleet("category,share\nhatchback,0.5\nsuv,0.3\nvan,0.1\nspaceship,0.1\n"),
        "spaceship, which Sightline does not know",
    ),
    "not a share": (fleet("category\nsuv\n"), "and a column share or registrations"),
    "a share that is none": (
        fleet("category,share\nsuv,many\n"),
        "line 2: share is “many”, which is not a number",
    ),
    "a negative share": (fleet("category,share\nsuv,-1\nvan,2\n"), "row 2: share is -1"),
    "an empty fleet": (fleet("category,share\n"), "has no row"),
    "a survey without poses": (invented(poses=0), "another has no camera pose"),
    "the same package twice": (lambda _, four: [*four, four[1]], "packages of the same survey"),
    "a package without a column that is read": (
        of_another_version,
        "(version 0.0.9) lacks the column u_inset_m of measurements.csv",
    ),
    **{
        f"a word of {table} that is not known: {column}": (
            strange(table, column),
            f"(version 9.0.0) has “hovering” in the column {column} of {table}.csv",
        )
        for table, column in (
            *(("measurements", "target"), ("measurements", "verdict"), ("vehicles", "category")),
            *(("vehicles", "lighting"), ("recordings", "lighting"), ("classes", "class_set")),
        )
    },
    "a fleet of nobody": (fleet("category,registrations\nsuv,0\n"), "category sums to 0 vehicles"),
    "shares and registrations": (
        fleet("category,share,registrations\nsuv,1,7\n"),
        "keep the one that counts",
    ),
    "a column twice": (fleet("category,share,share\nsuv,1,0.5\n"), "line 1: the column share is named twice"),
    "a number beyond all fleets": (
        fleet("category,registrations\nsuv,1e308\n"),
        "registrations is 1e308",
    ),
    "a folder without packages": (lambda tmp_path, _: [str(tmp_path / "nothing")], "is not a package"),
    "a site that is not told": (sites("site,stratum\nsite 0,a\n"), "no row for site 1"),
    "more sites than there are": (
        sites("site,stratum,sites_there\n" + "".join(f"site {n},a,3\n" for n in range(4))),
        "Stratum a has 4 sites here",
    ),
    "a part of a site": (sites("site,stratum,sites_there\nsite 0,a,3.5\n"), "3.5, not a whole number from 1"),
    "no site at all": (sites("site,stratum,sites_there\nsite 0,a,0\n"), "0, not a whole number from 1"),
    "traffic of some": (
        sites("site,stratum,traffic\nsite 0,a,5\n" + "".join(f"site {n},a,\n" for n in (1, 2, 3))),
        "traffic is given for some sites only",
    ),
}


@pytest.mark.parametrize("what", BAD)
def test_bad_input_is_one_sentence(
    what: str, four: list[str], tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    make, said = BAD[what]
    assert main(["study", *make(tmp_path, four), "-o", str(tmp_path / "study"), "--quick"]) == 2
    printed = capsys.readouterr()
    assert said in printed.err and printed.err.count("\n") == 1 and not printed.out
    assert not (tmp_path / "study").exists()


def test_an_output_that_cannot_be_written_is_one_sentence(
    four: list[str], tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "file").write_text("a file, where a folder would have to be")
    assert main(["study", *four, "-o", str(tmp_path / "file" / "study"), "--quick"]) == 2
    said = capsys.readouterr().err
    assert "cannot be written" in said and said.count("\n") == 1


@pytest.mark.parametrize("below", ["", "study"])
def test_a_study_never_takes_a_package_s_place(
    below: str, four: list[str], tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["study", *four, "-o", str(Path(four[0]) / below), "--quick"]) == 2
    printed = capsys.readouterr()
    assert "is a package of a survey, or lies in one" in printed.err and printed.err.count("\n") == 1
    assert (Path(four[0]) / "audit.csv").is_file()


def test_a_package_without_its_description_is_refused(
    four: list[str], tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (Path(four[0]) / "datapackage.json").unlink()
    assert main(["study", *four, "-o", str(tmp_path / "study"), "--quick"]) == 2
    assert "datapackage.json is missing" in capsys.readouterr().err


def test_a_stratum_with_one_site_says_that_it_says_nothing(
    four: list[str], tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "sites.csv").write_text("site,stratum\nsite 0,a\nsite 1,a\nsite 2,a\nsite 3,lonely\n")
    told = studied(capsys, *four, "-o", str(tmp_path / "study"), "--sites", str(tmp_path / "sites.csv"))
    reasons = {one["reason"] for one in told["figures"] if one["target"] == "roof"}
    assert reasons == {
        "lonely has one site: join it with another stratum, because differences between sites need two"
    }
