"""The catalogue: completion by beginnings of words, and CSV files of other people."""

import unicodedata
from typing import Any

import pytest

from sightline.infra.services import Services
from sightline.vehicles.catalogue.store import catalogue_of_models
from tests.support.app import Client, error_of

pytestmark = pytest.mark.dialect


def send(client: Client, content: bytes, name: str = "cars.csv") -> object:
    return client.post("/catalogue/import", files={"file": (name, content, "text/csv")})


def test_rows_that_can_be_used_are_stored_and_the_others_named(operator: Client, viewer: Client) -> None:
    lines = (
        "\ufeffmake,model,year_from,year_to,category,height_m,length_m,source\r\n"
        'Corvane,"Lindo, long",2016,2023,hatchback,1.46,4.02,"brochure"\r\n'
        "Corvane,Ridda,2018,,suv,1675,4.52,in millimetres\r\n"
        "\r\n"
        ",Nameless,,,,1.5,4.0,\r\n"
        "Tesmer,Juna,abc,,,1.45,4.2,\r\n"
        "Citroën,Évasion,2001,,van,1.71,4.45,\r\n"
    )
    answer = send(operator, lines.encode())
    assert answer.status_code == 200, answer.text  # type: ignore[attr-defined]
    found = answer.json()  # type: ignore[attr-defined]
    assert (found["added"], found["updated"]) == (2, 0)
    refused = [one for one in found["plan"]["rows"] if one["change"] == "refused"]
    assert [one["line"] for one in refused] == [3, 5, 6]
    assert "metres" in refused[0]["words"]["message"]
    assert [one["model"] for one in viewer.seen("/catalogue?q=corv li")] == ["Lindo, long"]
    assert viewer.seen("/catalogue?q=citroen eva")[0]["make"] == "Citroën"
    assert viewer.seen("/catalogue?q=vane") == []
    again = send(operator, lines.encode()).json()  # type: ignore[attr-defined]
    assert (again["added"], again["updated"]) == (0, 0) and again["plan"]["counts"]["same"] == 2


@pytest.mark.once
def test_a_list_with_semicolons_is_read_and_decimal_commas_are_named(operator: Client) -> None:
    content = b"make;model;height;length;width\nAudi;A3;1.43;4.34;1.82\nAudi;A4;1,43;4.7;1.8\n"
    done = send(operator, content).json()  # type: ignore[attr-defined]
    assert (done["added"], done["plan"]["counts"]["refused"]) == (1, 1)
    assert (
        "line 3: height is “1,43”; write decimals with a point" in done["plan"]["rows"][0]["words"]["message"]
    )
    assert operator.seen("/catalogue?q=a3")[0]["height_m"] == 1.43


@pytest.mark.once
@pytest.mark.parametrize(
    ("content", "taken", "refused"),
    [
        (
            "make,model,wheelbase_m\nAldo,One,2,785\nAldo,Three,2.6\nBeppo,Van,3,098\n",
            1,
            {2: "has 4 cells", 4: "4"},
        ),
        (
            'make,model,height_m\nAldo,"One,1.48\nAldo,Two,1.51\nBeppo,Bus,3.0\n',
            2,
            {2: "a quote is not closed"},
        ),
        ("make,model,year_from,height_m\nAldo,One,2019²,1.48\nAldo,Two,2018,1.51\n", 1, {2: "“2019²”"}),
        (
            'make,model,height_m\nAldo,"One\nand more",1.48\nAldo,Two,1.51\n',
            1,
            {2: "not closed", 3: "of the cell"},
        ),
    ],
)
def test_a_row_that_is_not_sound_is_refused_alone(
    operator: Client, content: str, taken: int, refused: dict[int, str]
) -> None:
    plan = send(operator, content.encode()).json()["plan"]  # type: ignore[attr-defined]
    told = {row["line"]: row["words"]["message"] for row in plan["rows"] if row["change"] == "refused"}
    assert (plan["counts"]["new"], set(told)) == (taken, set(refused))
    assert all(said in told[line] for line, said in refused.items())


def test_a_name_is_the_same_however_its_marks_are_written(operator: Client) -> None:
    content = "make,model,year_from,height_m\nCitro\u00ebn,Berlingo,2018,1.80\n\u0160koda,Octavia,2020,1.47\n"
    assert send(operator, content.encode()).json()["added"] == 2  # type: ignore[attr-defined]
    again = send(operator, unicodedata.normalize("NFD", content).encode()).json()  # type: ignore[attr-defined]
    assert (again["added"], again["plan"]["counts"]["same"]) == (0, 2)


@pytest.mark.once
def test_a_file_that_is_no_table_is_refused_in_words(operator: Client) -> None:
    for content, word in (
        (b"", "make"),
        (b"colour,size\nred,3\n", "make"),
        (b"\x89PNG\r\n\x1a\n\x00\x00", "UTF-8"),
        (b"make,model,height_m\nAudi,A3,high\n", "line 2"),
        (b"make,model,height_m,height_m\nKia,Rio,1.45,1.46\n", "line 1: the column height_m is named twice"),
    ):
        answer = send(operator, content)
        assert answer.status_code == 422  # type: ignore[attr-defined]
        sentence = error_of(answer)  # type: ignore[arg-type]
        assert word in sentence and "cars.csv" in sentence


@pytest.mark.once
def test_a_preview_is_in_the_language_that_is_asked_for(operator: Client) -> None:
    content = 'make,model,height_m\nAldo,One,"1,43"\nAldo,Two,1.43\nAldo,Two,1.5\n'
    files = {"file": ("cars.csv", content.encode(), "text/csv")}
    french = {"Accept-Language": "fr"}
    answer = operator.http.post("/api/catalogue/import/preview", files=files, headers=french).json()
    said = {one["line"]: one["words"]["message"] for one in answer["rows"] if one["words"]}
    assert "cars.csv, ligne 2" in said[2] and "avec un point" in said[2]
    assert said[4].startswith("Même modèle que la ligne 3 avec d’autres valeurs")


def test_a_model_added_by_hand_is_found(operator: Client, viewer: Client) -> None:
    row = {"make": "Nordal", "model": "Taiga", "year_from": 2013, "height_m": 1.735, "category": "suv"}
    assert operator.made("/catalogue", row)["height_m"] == 1.735
    assert "already" in error_of(operator.post("/catalogue", {**row, "model": "TAIGA "}))
    row["model"] = "Taiga Long"
    assert viewer.seen("/catalogue?q=2013 tai")[0]["make"] == "Nordal"
    assert operator.post("/catalogue", {**row, "height_m": 1735}).status_code == 422


def preview(client: Client, content: str, query: str = "") -> dict[str, Any]:
    files = {"file": ("cars.csv", content.encode(), "text/csv")}
    answer = client.post(f"/catalogue/import/preview?{query}", files=files)
    assert answer.status_code == 200, answer.text
    return dict(answer.json())


def words_of(plan: dict[str, Any]) -> dict[int, tuple[str, str]]:
    return {
        one["line"]: (one["change"], (one["words"] or {"message": ""})["message"]) for one in plan["rows"]
    }


def test_each_line_that_is_not_plain_is_named_and_nothing_is_stored_before(
    operator: Client, viewer: Client
) -> None:
    send(operator, b"make,model,year_from,height_m,source\nAudi,A3,2012,1.43,brochure\nBMW,i3,2013,,\n")
    content = (
        "make,model,year_from,height_m,taillight_m,u_taillight_m\n"
        "Audi,A3,2012,1.45,0.71,0.01\n"
        "BMW,i3,2013,1.58,,\n"
        "Kia,Rio,2017,1.45,,\n"
        "Kia,RIO,2017,1.45,,\n"
        "Kia,Rio,2017,1.46,,\n"
        "Kia,Ceed,2018,14.5,,\n"
        "Kia,Ceed,2018,1.447,,2.5\n"
    )
    plan = preview(operator, content)
    assert plan["problem"] is None
    assert plan["counts"] == {"new": 1, "update": 1, "same": 0, "conflict": 1, "duplicate": 2, "refused": 2}
    named = words_of(plan)
    assert named[2][0] == "conflict" and "1.450 m here, height 1.430 m (brochure) there" in named[2][1]
    assert named[3] == ("update", "Fills in height_m.")
    assert "line 4" in named[5][1] and "1.460 m here" in named[6][1]
    assert "in feet it would be 4.420 m" in named[7][1] and "u_taillight_m" in named[8][1]
    assert viewer.seen("/catalogue?q=kia") == []
    kept = send(operator, content.encode()).json()  # type: ignore[attr-defined]
    assert (kept["added"], kept["updated"]) == (1, 2)
    audi = viewer.seen("/catalogue?q=audi")[0]
    assert (audi["height_m"], audi["taillight_m"], audi["u_taillight_m"]) == (1.43, 0.71, 0.01)
    assert (audi["source"], audi["height_source"]) == ("brochure", "brochure")
    files = {"file": ("cars.csv", content.encode(), "text/csv")}
    operator.post("/catalogue/import?on_conflict=replace", files=files)
    assert viewer.seen("/catalogue?q=audi")[0]["height_m"] == 1.45


def test_a_conflict_that_keeps_what_there_is_changes_nothing(operator: Client, viewer: Client) -> None:
    """Not counted as changed, neither before nor after; the version, which others wait on, stays."""
    send(operator, b"make,model,year_from,height_m,source\nAudi,A3,2012,1.43,brochure\nBMW,i3,2013,1.58,\n")
    versions = [one["version"] for one in viewer.seen("/catalogue?q=")]
    content = "make,model,year_from,height_m\nAudi,A3,2012,1.45\nBMW,i3,2013,1.59\n"
    plan = preview(operator, content)
    assert (plan["counts"]["conflict"], plan["stored"]) == (2, 0)
    kept = send(operator, content.encode()).json()  # type: ignore[attr-defined]
    assert (kept["added"], kept["updated"]) == (0, 0)
    assert [one["version"] for one in viewer.seen("/catalogue?q=")] == versions
    assert preview(operator, content, "on_conflict=replace")["stored"] == 2


@pytest.mark.once
def test_feet_that_pass_for_metres_are_refused_as_a_whole(operator: Client, viewer: Client) -> None:
    content = "make,model,height_m,length_m\n" + "".join(
        f"Make,Model {n},{4.7 + 0.01 * n:.2f},{14.2 + 0.1 * n:.1f}\n" for n in range(20)
    )
    sentence = error_of(send(operator, content.encode()))  # type: ignore[arg-type]
    assert "height_m" in sentence and "feet" in sentence and "Nothing was saved" in sentence
    assert "feet" in preview(operator, content)["problem"]["message"]
    assert viewer.seen("/catalogue?q=make") == []
    plan = preview(operator, content, "unit=ft")
    assert plan["problem"] is None and plan["counts"]["new"] == 20
    operator.post("/catalogue/import?unit=ft", files={"file": ("c.csv", content.encode(), "text/csv")})
    found = viewer.seen("/catalogue?q=make 0")[0]
    assert (found["height_m"], found["length_m"]) == (1.43256, 4.32816)


@pytest.mark.once
def test_units_are_read_from_headers_and_columns_are_mapped(operator: Client, viewer: Client) -> None:
    content = (
        "Marque;Modèle;Height (mm);Length_cm;Wheelbase [in];Couleur\nRenault;Zoe;1562;408.7;101.9;blue\n"
    )
    unmapped = preview(operator, content)  # not refused: the page has to show the columns to be mapped
    assert "no column make and no column model" in unmapped["problem"]["message"] and unmapped["stored"] == 0
    assert [one["header"] for one in unmapped["columns"]][:2] == ["Marque", "Modèle"]
    files = {"file": ("c.csv", content.encode(), "text/csv")}
    assert operator.post("/catalogue/import", files=files).status_code == 422
    query = "column=make%3DMarque&column=model%3DMod%C3%A8le"
    plan = preview(operator, content, query)
    assert [(one["field"], one["unit"]) for one in plan["columns"]] == [
        ("make", None),
        ("model", None),
        ("height_m", "mm"),
        ("length_m", "cm"),
        ("wheelbase_m", "in"),
        (None, None),
    ]
    operator.post(f"/catalogue/import?{query}", files={"file": ("c.csv", content.encode(), "text/csv")})
    zoe = viewer.seen("/catalogue?q=zoe")[0]
    assert (zoe["height_m"], zoe["length_m"], zoe["wheelbase_m"]) == (1.562, 4.087, 2.58826)
    assert "no field" in error_of(
        operator.post(
            "/catalogue/import/preview?column=hight%3DMarque", files={"file": ("c.csv", b"Marque,b\n")}
        )
    )


@pytest.mark.once
def test_a_u_without_a_unit_has_that_of_its_size(operator: Client, viewer: Client) -> None:
    send(
        operator,
        b"make,model,u_height,height (mm),wheelbase (mm),u_wheelbase\nDacia,Jogger,0.8,1632,2897,0.5\n",
    )
    jogger = viewer.seen("/catalogue?q=jogger")[0]
    assert (jogger["u_height_m"], jogger["u_wheelbase_m"]) == (0.0008, 0.0005)


@pytest.mark.once
def test_what_fills_a_gap_takes_no_u_from_a_size_that_it_repeats(operator: Client, viewer: Client) -> None:
    send(operator, b"make,model,height_m,u_height_m,height_source\nLada,Niva,1.64,0.005,tape\n")
    again = b"make,model,height_m,wheelbase_m,source\nLada,Niva,1.640,2.2,a list\n"
    assert preview(operator, again.decode())["rows"][0]["words"]["message"] == "Fills in wheelbase_m."
    send(operator, again)
    niva = viewer.seen("/catalogue?q=niva")[0]
    assert (niva["wheelbase_m"], niva["wheelbase_source"]) == (2.2, "a list")
    assert (niva["height_m"], niva["u_height_m"], niva["height_source"]) == (1.64, 0.005, "tape")


@pytest.mark.once
def test_another_u_of_the_same_size_is_a_conflict(operator: Client, viewer: Client) -> None:
    rows = "make,model,height_m,u_height_m\nLada,Niva,1.64,{u}\n"
    send(operator, rows.format(u="0.017").encode())
    (row,) = preview(operator, rows.format(u="0.005"))["rows"]
    assert row["change"] == "conflict" and "u_height_m 0.017" in row["words"]["message"]
    files = {"file": ("cars.csv", rows.format(u="0.005").encode(), "text/csv")}
    for answer, u_m in (("keep", 0.017), ("replace", 0.005)):
        assert operator.post(f"/catalogue/import?on_conflict={answer}", files=files).status_code == 200
        assert viewer.seen("/catalogue?q=niva")[0]["u_height_m"] == u_m


def test_models_are_found_in_any_case_of_any_letters(operator: Client, services: Services) -> None:
    send(operator, "make,model,wheelbase_m\nŠkoda,Rapid É,2.6\nSeat,Ibiza,2.56\n".encode())
    with services.reading() as session:
        found = catalogue_of_models(session, [("ŠKODA", "rapid é"), ("seat", "IBIZA"), ("Seat", "Leon")])
    assert [(one.make, one.wheelbase_m) for one in found] == [("Seat", 2.56), ("Škoda", 2.6)]


@pytest.mark.once
def test_an_expanded_uncertainty_is_not_read_as_a_standard_one(operator: Client) -> None:
    rows = "make,model,Height_m,{u},u_wheelbase_m\nKia,Rio,1.45,0.02,0.01\n"
    for title in ("U_height_m", "U_roof (mm)", "U95_height_m", "u95 height (mm)"):
        plan = preview(operator, rows.format(u=title))
        fields = [one["field"] for one in plan["columns"]]
        assert fields == ["make", "model", "height_m", None, "u_wheelbase_m"]
        assert f"“{title}” of cars.csv has the capital U" in plan["problem"]["message"]
        answer = send(operator, rows.format(u=title).encode())
        assert answer.status_code == 422 and "k = 1" in error_of(answer)  # type: ignore[attr-defined,arg-type]
    assert preview(operator, rows.format(u="U_height_m"), query="column==U_height_m")["problem"] is None
    chosen = preview(operator, rows.format(u="U_height_m"), query="column=u_height_m=U_height_m")
    assert "capital U" in chosen["problem"]["message"]
    assert preview(operator, rows.format(u="U_note"))["problem"] is None
    shouted = preview(operator, rows.format(u="U_HEIGHT_M"))
    assert (shouted["columns"][3]["field"], shouted["problem"]) == ("u_height_m", None)


def test_a_model_is_corrected_retired_and_brought_back(operator: Client, viewer: Client) -> None:
    row = {"make": "Opel", "model": "Corsa", "year_from": 2019, "height_m": 1.435, "source": "brochure"}
    made = operator.made("/catalogue", row)
    path = f"/catalogue/{made['id']}"
    corrected = operator.put(path, {**row, "height_m": 1.433, "headlight_m": 0.66, "version": 1}).json()
    assert (corrected["height_m"], corrected["headlight_m"], corrected["version"]) == (1.433, 0.66, 2)
    late = operator.put(path, {**row, "version": 1})
    assert late.status_code == 409 and late.json()["current"]["height_m"] == 1.433
    assert operator.post(f"{path}/retire", {"version": 2, "retired": True}).json()["retired_at"]
    assert viewer.seen("/catalogue?q=corsa") == []
    assert viewer.seen("/catalogue/page?q=corsa")["total"] == 0
    assert viewer.seen("/catalogue/page?q=corsa&retired=true")["entries"][0]["id"] == made["id"]
    operator.post(f"{path}/retire", {"version": 3, "retired": False})
    assert viewer.seen("/catalogue?q=corsa")[0]["version"] == 4


def test_what_is_exported_is_imported_again(operator: Client, viewer: Client) -> None:
    send(
        operator,
        b"make,model,year_from,category,height_m,u_height_m,taillight_m,taillight_source,source\n"
        b"'=Odd,A3,2012,suv,1.43,0.005,0.7,tape,brochure\nBMW,i3,,,,,,,\n",
    )
    content = viewer.get("/catalogue/export").text
    before = viewer.seen("/catalogue/page")["entries"]
    assert content.splitlines()[1].startswith("'=Odd,A3,2012,,suv,1.430000,0.005000,,")
    plan = preview(operator, content)
    assert plan["counts"]["same"] == 2 and plan["problem"] is None
    assert viewer.seen("/catalogue/page")["entries"] == before


@pytest.mark.once
@pytest.mark.parametrize(
    ("content", "words"),
    [
        ("make,model,height_m\n", "no line of models"),
        ("make,model,height_m,taillight_m\nKia,Rio,1.45,1.9\n", "taillight_m is 1.9 and height_m is 1.45"),
        ("make,model,length_m,wheelbase_m\nKia,Rio,4.1,4.2\n", "wheelbase_m is 4.2 and length_m is 4.1"),
        ("make,model,height_m,u_height_m\nKia,Rio,1.45,0.8\n", "from 0 to 0.29"),
        ("make,model\nKia,\x00\n", "cannot be shown"),
        ("make,model,source\nKia,Rio,\x1b[31m\n", "cannot be shown"),
    ],
)
def test_what_no_model_can_have_is_stored_nowhere(operator: Client, content: str, words: str) -> None:
    before = operator.seen("/catalogue/page")["total"]
    plan = preview(operator, content)
    of_columns = [one["problem"] for one in plan["columns"]]
    said = [plan["problem"], *of_columns, *(one["words"] for one in plan["rows"])]
    assert any(words in one["message"] for one in said if one), said
    assert send(operator, content.encode()).status_code == 422  # type: ignore[attr-defined]
    assert operator.seen("/catalogue/page")["total"] == before
