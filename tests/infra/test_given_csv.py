"""The one reader of tables that people bring: what it takes, what it refuses, and that it never dies."""

import csv
import io
from unicodedata import normalize

import pytest
from hypothesis import given
from hypothesis import strategies as st

from sightline.errors import BadInput
from sightline.infra.given_csv import given_number, read_table, unit_of


def rows(data: bytes | str) -> list[dict[str, str]]:
    return [cells for _, cells in read_table(data, "a.csv").sound_rows()]


@pytest.mark.parametrize(
    "data",
    [
        b"id,height_m\n1,1.5\n2,1.6\n",
        b"\xef\xbb\xbfid,height_m\r\n1,1.5\r\n2,1.6\r\n",
        b"id,height_m\r1,1.5\r2,1.6",
        b"id;height_m\n1;1.5\n2;1.6\n",
        b"id\theight_m\n1\t1.5\n2\t1.6\n",
        b'"id";"height_m"\n"1";"1.5"\n"2";"1.6"\n',
        b"id,height_m,,\n1,1.5,,\n2,1.6,,,,\n",
        b"\n , \n id , height_m \n1, 1.5 \n\n,,\n2,1.6\n",
    ],
)
def test_every_way_to_write_a_table_is_read(data: bytes) -> None:
    assert rows(data) == [{"id": "1", "height_m": "1.5"}, {"id": "2", "height_m": "1.6"}]


def test_a_header_with_commas_and_semicolons_has_commas() -> None:
    assert read_table("id,a;b\n", "a.csv").header == ["id", "a;b"]
    assert read_table('"a, b";c\n', "a.csv").header == ["a, b", "c"]


def test_names_are_the_same_however_their_marks_are_written() -> None:
    assert rows("make\nCitroe\u0308n\n") == rows("make\nCitro\u00ebn\n") == [{"make": "Citroën"}]


@pytest.mark.parametrize(
    ("data", "said"),
    [
        (b"id,a,id\n", "a.csv, line 1: the column id is named twice"),
        (b"id,a\n1,2\n1,2,785\n", "a.csv, line 3 has 3 cells, but the header names 2; write decimals"),
        (b"id,a,\n1,2,3\n", "a.csv, line 2 has 3 cells, but the header names 2"),
        (b"id,a\n1\n", "a.csv, line 2 has 1 cells, but the header names 2; fill in"),
        (b'id,a\n1,"2\n', "a.csv, line 2: a quote is not closed on its line"),
        (b'id,a\n1,"two\nlines"\n', "a.csv, line 2: a quote is not closed on its line"),
        (b'"id,a\n1,2\n', "a.csv, line 1: a quote is not closed on its line"),
        (b'id,a\n1,"2"3\n', "a.csv, line 2: text follows a closing quote"),
        (b"\xff\xfei\x00d\x00", "a.csv is not a UTF-8 text"),
    ],
)
def test_what_is_not_sound_is_refused_with_its_line(data: bytes, said: str) -> None:
    with pytest.raises(BadInput, match=said) as refused:
        rows(data)
    assert refused.value.exit_status == 2


def test_a_table_that_is_too_large_is_refused() -> None:
    with pytest.raises(BadInput, match="larger than 1 MB"):
        read_table(b"a" * 1_000_001, "a.csv", 1_000_000)


def test_what_is_wrong_with_a_row_stands_in_the_row() -> None:
    """Of an open quote that line alone, and the line that may be the end of its cell."""
    table = read_table('make,model\nA,"One\nA,Two\nB,Van 15"\nB,Bus 12"\nB,1,2\n', "a.csv")
    problems = [row.problem.code if row.problem else None for row in table.rows]
    assert problems == ["csv-open-quote", None, "csv-cell-not-closed", None, "csv-more-cells"]
    assert [row.line for row in table.rows] == [2, 3, 4, 5, 6]
    assert table.by_column(table.rows[3]) == {"make": "B", "model": 'Bus 12"'}


def test_a_well_quoted_line_is_not_the_rest_of_another() -> None:
    table = read_table('a,b\n1,"x\n"2","y ""z"""\n', "a.csv")
    assert table.by_column(table.rows[1]) == {"a": "2", "b": 'y "z"'}
    assert table.rows[1].problem is None


def test_needed_columns_are_asked_for() -> None:
    with pytest.raises(BadInput, match="is empty; its first line must name the columns id, x"):
        read_table("\n", "a.csv").require("id", "x")
    with pytest.raises(BadInput, match="has no column x, y; its first line must name"):
        read_table("id\n", "a.csv").require("id", "x", "y")


@pytest.mark.parametrize("cell", ["1.5", " 15e-1 ", "+1.50", "1.5E0", "001.5"])
def test_numbers(cell: str) -> None:
    assert given_number(cell) == 1.5


@pytest.mark.parametrize(
    "cell", ["", "nan", "inf", "1e999", "1_5", "٣", "2019²", "0x1", "1.5 m", "1,5", "--1"]
)
def test_what_is_no_number(cell: str) -> None:
    assert given_number(cell) is None


@pytest.mark.parametrize(
    ("cell", "said"),
    [
        ("1,48", "a.csv, line 7: h is “1,48”; write decimals with a point and nothing between thousands"),
        ("1.234,5", "nothing between thousands"),
        ("1 234.5", "nothing between thousands"),
        ("1\u202f234", "nothing between thousands"),
        ("1'234", "nothing between thousands"),
        ("2019²", "a.csv, line 7: h is “2019²”, which is not a number; correct the cell."),
        ("", "a.csv, line 7: h is empty; fill in the cell."),
    ],
)
def test_what_is_wrong_with_a_number_is_said(cell: str, said: str) -> None:
    with pytest.raises(BadInput, match=said):
        read_table("h\n", "a.csv").number(7, "h", cell)


@pytest.mark.parametrize(
    ("value", "unit", "said"), [("1400", "mm", "1.4"), ("148", "cm", "1.48"), ("63", "in", "1.6")]
)
def test_a_size_that_no_vehicle_has_is_refused_with_its_unit(value: str, unit: str, said: str) -> None:
    table = read_table("h\n", "a.csv")
    with pytest.raises(BadInput, match=f"more than 20 m; in {unit} it would be {said}"):
        table.size_m(2, "h", value)
    assert table.size_m(2, "h", "20") == 20.0
    assert unit_of(-float(value)) == unit


# what a comma alone separates, and what may stand in a line
_CELL = st.text(st.characters(exclude_characters="\r\n", exclude_categories=["Cs"]), max_size=8)
_NAME = st.text("abcdefgh_ ", min_size=1, max_size=5).map(str.strip).filter(bool)


@given(st.data())
def test_any_table_that_python_writes_comes_back(data: st.DataObject) -> None:
    header = data.draw(st.lists(_NAME, min_size=1, max_size=4, unique=True))
    width = len(header)
    written = data.draw(st.lists(st.lists(_CELL, min_size=width, max_size=width), max_size=5))
    out = io.StringIO(newline="")
    csv.writer(out, lineterminator=data.draw(st.sampled_from(["\n", "\r\n", "\r"]))).writerows(
        [header, *written]
    )
    told = out.getvalue().encode()
    expected = [
        {name: normalize("NFC", cell).strip() for name, cell in zip(header, cells, strict=True)}
        for cells in written
        if any(map(str.strip, cells))
    ]
    assert rows(told) == expected


@given(st.binary(max_size=60) | st.text('a1,;\t"\r\n\ufeff', max_size=40).map(str.encode))
def test_no_bytes_are_a_traceback(data: bytes) -> None:
    try:
        table = read_table(data, "a.csv")
    except BadInput as refused:
        assert refused.message
        return
    for row in table.rows:
        assert len(row.cells) == len(table.header)
        assert row.problem is None or row.problem.message
