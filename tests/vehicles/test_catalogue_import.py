"""The catalogue: completion by beginnings of words, and CSV files of other people."""

import pytest

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
    assert [one["line"] for one in found["skipped"]] == [3, 5, 6]
    assert "metres" in found["skipped"][0]["reason"]
    assert [one["model"] for one in viewer.seen("/catalogue?q=corv li")] == ["Lindo, long"]
    assert viewer.seen("/catalogue?q=citroen eva")[0]["make"] == "Citroën"
    assert viewer.seen("/catalogue?q=vane") == []
    again = send(operator, lines.encode()).json()  # type: ignore[attr-defined]
    assert (again["added"], again["updated"]) == (0, 2)


def test_a_list_with_semicolons_and_decimal_commas_is_read(operator: Client) -> None:
    content = b"make;model;height;length;width\nAudi;A3;1,43;4,34;1,82\n"
    assert send(operator, content).json()["added"] == 1  # type: ignore[attr-defined]
    assert operator.seen("/catalogue?q=a3")[0]["height_m"] == 1.43


def test_a_file_that_is_no_table_is_refused_in_words(operator: Client) -> None:
    for content, word in (
        (b"", "make"),
        (b"colour,size\nred,3\n", "make"),
        (b"\x89PNG\r\n\x1a\n\x00\x00", "UTF-8"),
        (b"make,model,height_m\nAudi,A3,high\n", "line 2"),
    ):
        answer = send(operator, content)
        assert answer.status_code == 422  # type: ignore[attr-defined]
        sentence = error_of(answer)  # type: ignore[arg-type]
        assert word in sentence and "cars.csv" in sentence


def test_a_model_added_by_hand_is_found(operator: Client, viewer: Client) -> None:
    row = {"make": "Nordal", "model": "Taiga", "year_from": 2013, "height_m": 1.735, "category": "suv"}
    assert operator.made("/catalogue", row)["height_m"] == 1.735
    assert viewer.seen("/catalogue?q=2013 tai")[0]["make"] == "Nordal"
    assert operator.post("/catalogue", {**row, "height_m": 1735}).status_code == 422
