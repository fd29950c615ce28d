"""The geometry commands from the outside: files in, files out, one sentence per error."""

import csv
import json
import re
from contextlib import closing
from fractions import Fraction
from pathlib import Path

import av
import cv2
import numpy as np
import pytest

from sightline.cameras.camera_files import calibration_views, pose_detections
from sightline.cli import main
from sightline.commands.clicks import Assumed, assumed_inset
from sightline.commands.plan import _mm
from sightline.commands.pose import expected_lines
from sightline.coverage import expanded
from sightline.geometry.board import Board
from sightline.geometry.documents import camera_to_dict, pose_to_dict
from sightline.geometry.height import measure_height
from sightline.geometry.insets import USUAL_INSETS
from sightline.geometry.pose import expected_u
from tests.geometry.scenes import camera_of, pose_of
from tests.geometry.simulate import Lens, Scene, picture

SCENE = Scene(Lens(), (-0.7, -3.0, 1.4), 18.0, 4.0)
BOARD = ("--board", "6x4", "--square", "0.1")
HEADER = "id,contact_x_px,contact_y_px,target_x_px,target_y_px"


def run(*arguments: object) -> int:
    return main([str(a) for a in arguments])


@pytest.fixture
def camera_file(tmp_path: Path) -> Path:
    path = tmp_path / "camera.json"
    path.write_text(json.dumps(camera_to_dict(camera_of(Lens()))))
    return path


@pytest.fixture
def pose_file(tmp_path: Path) -> Path:
    path = tmp_path / "pose.json"
    path.write_text(json.dumps(pose_to_dict(pose_of(SCENE))))
    return path


@pytest.fixture
def still(tmp_path: Path) -> Path:
    path = tmp_path / "board.png"
    cv2.imwrite(str(path), picture(SCENE, 6, 4, 0.1, 1.5, samples=5))
    return path


def clicks(travel: float = 0.0) -> np.ndarray:
    return SCENE.look([(0.3 + travel, 0.2, 0.0), (0.1 + travel, 0.65, 1.16)])


def test_pose_then_height(camera_file, still, tmp_path, capsys) -> None:
    out = tmp_path / "pose.json"
    assert (
        run("pose", still, "--camera", camera_file, *BOARD, "--reference-height", 1.5, "-o", out, "--json")
        == 0
    )
    printed = json.loads(capsys.readouterr().out)
    assert printed["format"] == "sightline-pose-1" and printed["board"]["reference"] == "top"
    contact, target = (",".join(map(str, p)) for p in clicks())
    arguments = (
        "height",
        "--pose",
        out,
        "--contact",
        contact,
        "--target",
        target,
        "--inset",
        0.45,
        "--u-inset",
        0.1,
    )
    assert run(*arguments, "--json") == 0
    height = json.loads(capsys.readouterr().out)
    assert height["height_m"] == pytest.approx(1.16, abs=height["U95_height_m"])
    assert height["u_height_m"] == pytest.approx(np.sqrt(sum(e["u_m"] ** 2 for e in height["budget"])))
    assert height["status"] == "ok" and height["reason"] is None
    assert run(*arguments) == 0 and "m ±" in capsys.readouterr().out


def test_what_a_pose_lets_expect_is_without_an_insets_part() -> None:
    """Of a driver's eye 3 m away it is a good part: 20 mm where clicks and pose make 13."""
    pose, (inset_m, u_inset_m, _) = pose_of(SCENE), USUAL_INSETS["driver_eye_near"]
    expected = expected_u(pose)
    ((distance_m, u_m),) = [one for one in expected if one[0] == 3.0]
    assert u_m is not None
    contact, eye = SCENE.look([(-0.7, -3.0 + distance_m, 0.0), (-0.7, -3.0 + distance_m + inset_m, 1.16)])
    measured = measure_height(pose, contact, eye, 1.0, inset_m, u_inset_m)
    assert measured.U95_height_m is not None and measured.U95_height_m > 1.2 * expanded(u_m)
    lines = expected_lines(expected)
    assert lines and all(line.endswith("(95 %) without the inset's part") for line in lines)


def test_what_is_expected_below_1_cm_has_a_decimal() -> None:
    """A U95 of 0.4 mm was "± 0 mm"."""
    said = [
        line.partition(": ")[2].partition(" (")[0] for line in expected_lines([(3.0, 0.0002), (9.0, 0.0064)])
    ]
    assert said == ["± 0.4 mm", "± 13 mm"]


def test_not_measurable_is_an_answer(pose_file, capsys) -> None:
    assert run("height", "--pose", pose_file, "--contact", "320,5", "--target", "320,2", "--json") == 0
    answer = json.loads(capsys.readouterr().out)
    assert answer["status"] == "not_measurable" and "horizon" in answer["reason"]
    assert all(
        answer[k] is None for k in ("height_m", "u_height_m", "U95_height_m", "x_m", "y_m", "distance_m")
    )


@pytest.mark.parametrize(
    "arguments",
    [
        ("--contact", "1;2", "--target", "3,4"), ("--contact", "1,2"), (),
        ("--contact", "1,2,3", "--target", "3,4"),
        ("--contact", "1,2", "--target", "3,4", "--sigma", "-1"), ("--clicks", "none.csv", "-o", "x.csv"),
        ("--contact", "1,2", "--target", "3,4", "--sigma", "wide"),
        ("--clicks", "a.csv", "--contact", "1,2"), ("--contact", "1,2", "--target", "3,4", "--inset", "nan"),
        ("--contact", "nan,2", "--target", "3,4"), ("--contact", "1,2", "--target", "1e400,4"),
        ("--contact", "1_0,2", "--target", "3,4"),
        ("--contact", "1,2", "--target", "3,4", "--sigma", "1e300"),
    ],
)  # fmt: skip
def test_malformed_arguments_are_bad_input(pose_file, arguments, capsys) -> None:
    assert run("height", "--pose", pose_file, *arguments) == 2
    said = capsys.readouterr()
    assert said.out == "" and said.err.count("\n") == 1


@pytest.mark.parametrize("text", ["", "{", "[]", "{}", '{"format": "sightline-camera-1"}', "\xff\xfe"])
def test_bad_pose_files_are_named(tmp_path, text, capsys) -> None:
    path = tmp_path / "odd.json"
    path.write_bytes(text.encode("latin-1"))
    assert run("height", "--pose", path, "--contact", "1,2", "--target", "3,4") == 2
    error = capsys.readouterr().err
    assert "odd.json" in error and error.count("\n") == 1


def table(tmp_path: Path, pose_file: Path, text: str | bytes) -> list[dict[str, str]]:
    source, out = tmp_path / "clicks.csv", tmp_path / "heights.csv"
    source.write_bytes(text if isinstance(text, bytes) else text.encode())
    assert run("height", "--pose", pose_file, "--clicks", source, "-o", out) == 0
    raw = out.read_bytes()
    assert b"\r" not in raw and not raw.startswith(b"\xef\xbb\xbf") and raw.endswith(b"\n")
    return list(csv.DictReader(raw.decode().splitlines()))


def line(row: str, points: np.ndarray) -> str:
    return ",".join([row, *(repr(float(v)) for v in points.ravel())])


def test_many_clicks(tmp_path, pose_file, capsys) -> None:
    good = line("1", clicks())
    text = (
        f"{HEADER},sigma_px,inset_m,u_inset_m,note\n{good},,0.45,0.1,\"a, \"\"b\"\"\"\n"
        f"{good},2,0.45,0.1,=1+1\n"
        f"{good},x,,,\n3,1,2\n4,320,5,300,2,,,,\n{good},-1,,,\n5,,2,3,4,,,,\n\n6,nan,2,3,4,,,,-2.5\n"
    )  # fmt: skip
    rows = table(tmp_path, pose_file, b"\xef\xbb\xbf" + text.replace("\n", "\r\n").encode())
    assert [r["status"] for r in rows] == ["ok", "ok", *["not_measurable"] * 6]
    assert rows[0]["height_m"] == "1.160000" and rows[0]["note"] == 'a, "b"'
    assert float(rows[1]["u_height_m"]) > float(rows[0]["u_height_m"])
    assert rows[1]["note"] == "'=1+1" and rows[7]["note"] == "-2.5"
    assert float(rows[0]["U95_height_m"]) == pytest.approx(1.96 * float(rows[0]["u_height_m"]), abs=1e-5)
    assert "sigma_px" in rows[2]["reason"] and "3 cells" in rows[3]["reason"]
    assert all(r["height_m"] == "" and r["reason"] for r in rows[2:])
    assert all(r["solved_inset_m"] == "" for r in rows)
    assert list(rows[0])[-11:] == [
        "height_m", "u_height_m", "U95_height_m", "x_m", "y_m", "distance_m", "solved_inset_m",
        "u_solved_inset_m", "status", "reason", "flags",
    ]  # fmt: skip


def test_a_row_of_clicks_that_is_not_sound_is_refused_alone(tmp_path, pose_file, capsys) -> None:
    good = line("1", clicks()).replace(",", ";")
    text = (
        f"{HEADER},sigma_px,reference_height_m;\r".replace(",", ";") + f"{good};1;1.2;\r{good};0,5;1.2\r"
        f'{good};1;1200\r{good};1;"1.2\r{good};1;1.2;7\r{good};1;1.2\r'
    )  # fmt: skip
    rows = table(tmp_path, pose_file, text.encode())
    assert [r["status"] for r in rows] == ["ok", *["not_measurable"] * 4, "ok"]
    for row, said in zip(
        rows[1:5],
        ("write decimals with a point", "in mm it would be", "not closed", "header names"),
        strict=True,
    ):
        assert said in row["reason"] and row["reason"].startswith("clicks.csv, line ")


@pytest.mark.parametrize(
    "option, value",
    [("--sigma", 2), ("--inset", 0.45), ("--u-inset", 0.1), ("--kind", "roof"), ("--side", "far")],
)
def test_options_that_a_table_would_ignore_are_refused(tmp_path, pose_file, option, value, capsys) -> None:
    table, out = tmp_path / "clicks.csv", tmp_path / "heights.csv"
    table.write_text(HEADER + "\n")
    assert run("height", "--pose", pose_file, "--clicks", table, option, value, "-o", out) == 2
    assert option in capsys.readouterr().err and not out.exists()


def test_one_height_writes_no_file_and_takes_no_infinite_inset(tmp_path, pose_file, capsys) -> None:
    pair = ("height", "--pose", pose_file, "--contact", "1,2", "--target", "3,4")
    assert run(*pair, "-o", tmp_path / "out.csv") == 2
    assert "--output has no effect" in capsys.readouterr().err
    assert run(*pair, "--inset", "inf") == 2
    assert "finite" in capsys.readouterr().err


def test_two_frames_solve_the_inset(tmp_path, pose_file) -> None:
    header = HEADER + ",contact2_x_px,contact2_y_px,target2_x_px,target2_y_px"
    both = line("1", np.concatenate([clicks(), clicks(1.2)]))
    part = line("2", clicks()) + ",3,,,"
    rows = table(tmp_path, pose_file, f"{header}\n{both}\n{line('3', clicks())},,,,\n{part}\n")
    assert rows[0]["status"] == "ok", rows[0]
    assert float(rows[0]["height_m"]) == pytest.approx(1.16, abs=1e-6)
    assert float(rows[0]["solved_inset_m"]) == pytest.approx(0.45, abs=1e-5)
    assert 0 < float(rows[0]["u_solved_inset_m"]) < 0.2
    assert rows[1]["solved_inset_m"] == "" and float(rows[1]["height_m"]) != pytest.approx(1.16, abs=1e-3)
    assert rows[2]["status"] == "not_measurable" and "contact2_y_px" in rows[2]["reason"]


EYE_NEAR, EYE_FAR = (0.45, 0.10), (1.15, 0.15)


def printed(capsys, pose_file, *options: object) -> dict:
    contact, target = (",".join(map(str, p)) for p in clicks())
    pair = ("--contact", contact, "--target", target, "--json")
    assert run("height", "--pose", pose_file, *pair, *options) == 0
    return json.loads(capsys.readouterr().out)


def test_a_kind_brings_its_usual_inset_and_an_eye_needs_its_side(pose_file, capsys) -> None:
    plain = printed(capsys, pose_file)
    assert plain["inset_m"] == 0 and "inset taken as 0" in plain["flags"]
    for side, inset in (("near", EYE_NEAR), ("far", EYE_FAR)):
        eye = printed(capsys, pose_file, "--kind", "driver_eye", "--side", side)
        given = printed(capsys, pose_file, "--inset", inset[0], "--u-inset", inset[1])
        assert (eye["inset_m"], eye["u_inset_m"]) == inset
        assert eye["height_m"] == given["height_m"] and eye["u_height_m"] == given["u_height_m"]
        assert f"usual inset of driver_eye, {side}" in eye["flags"] and "usual" not in str(given["flags"])
    silent = printed(capsys, pose_file, "--kind", "driver_eye")
    assert silent["status"] == "not_measurable" and "near" in silent["reason"] and "far" in silent["reason"]
    assert [silent[k] for k in ("height_m", "u_height_m", "inset_m", "u_inset_m")] == [None] * 4
    told = printed(capsys, pose_file, "--kind", "driver_eye", "--inset", 0.45)
    assert told["height_m"] == pytest.approx(1.16, abs=1e-9)
    assert "uncertainty of the inset taken as 0" in told["flags"]
    roof = printed(capsys, pose_file, "--kind", "roof", "--u-inset", 0.2)
    assert (roof["inset_m"], roof["u_inset_m"]) == (0.30, 0.2) and "usual inset of roof" in roof["flags"]


def test_the_usual_insets_are_those_of_the_documentation() -> None:
    text = (Path(__file__).parents[2] / "docs" / "formats.md").read_text()
    rows = re.findall(r"^\| (`\w+`[^|]*) \| ([\d.]+), ([\d.]+) \|", text, re.MULTILINE)
    assert len(rows) == 5
    for words, *told in rows:
        first, *others = re.findall(r"`(\w+)`", words)
        side = others[1] if others[:1] == ["side"] else ""
        for target in (first, *([] if side else others)):
            usual = assumed_inset(target, side)
            assert isinstance(usual, Assumed)
            assert [usual.inset_m, usual.u_inset_m] == [float(one) for one in told], target


def test_rows_with_a_target_take_its_usual_inset(tmp_path, pose_file) -> None:
    pair = line("", clicks())[1:]
    cells = ("driver_eye,near,,", "driver_eye,far,,", "driver_eye,,,", "driver_eye,,0.45,", ",,,",
             "roof,,,", "roof,,,0.2", "bonnet,,,", "driver_eye,left,,", "taillight,far,,")  # fmt: skip
    text = "\n".join(f"{i},{pair},{row}" for i, row in enumerate(cells))
    rows = table(tmp_path, pose_file, f"{HEADER},target,side,inset_m,u_inset_m\n{text}\n")
    near, far, silent, told, plain, roof, wide, odd, wrong, lamp = rows
    assert near["height_m"] == told["height_m"] == "1.160000" and float(far["height_m"]) < 1.12
    assert float(near["u_height_m"]) > float(told["u_height_m"])
    assert [r["flags"].split(" | ")[0] for r in (near, far, told, plain, roof, wide, lamp)] == [
        "usual inset of driver_eye, near", "usual inset of driver_eye, far",
        "uncertainty of the inset taken as 0", "inset taken as 0", "usual inset of roof",
        "usual inset of roof", "usual inset of taillight",
    ]  # fmt: skip
    assert {r["status"] for r in (silent, odd, wrong)} == {"not_measurable"}
    assert "near or far" in silent["reason"] and silent["flags"] == ""
    assert "bonnet" in odd["reason"] and "left" in wrong["reason"]
    assert float(wide["u_height_m"]) > float(roof["u_height_m"])


def test_an_eye_in_two_frames_needs_no_side(tmp_path, pose_file) -> None:
    header = HEADER + ",contact2_x_px,contact2_y_px,target2_x_px,target2_y_px,target"
    both = line("1", np.concatenate([clicks(), clicks(1.2)])) + ",driver_eye"
    (row,) = table(tmp_path, pose_file, f"{header}\n{both}\n")
    assert float(row["height_m"]) == pytest.approx(1.16, abs=1e-6) and "inset taken" not in row["flags"]


def test_header_only_gives_only_a_header(tmp_path, pose_file) -> None:
    assert table(tmp_path, pose_file, HEADER + "\n") == []
    assert (tmp_path / "heights.csv").read_text().count("\n") == 1


def test_heights_can_be_measured_again(tmp_path, pose_file) -> None:
    first = table(tmp_path, pose_file, f"{HEADER}\n{line('1', clicks())}\n")
    again = table(tmp_path, pose_file, (tmp_path / "heights.csv").read_bytes())
    assert first == again


@pytest.mark.parametrize("text", ["", "id;contact_x_px\n1;2\n", "a,b\n1,2\n", f"{HEADER},id\n", '"open\n'])
def test_bad_tables_are_bad_input_and_write_nothing(tmp_path, pose_file, text, capsys) -> None:
    source, out = tmp_path / "clicks.csv", tmp_path / "heights.csv"
    source.write_text(text)
    assert run("height", "--pose", pose_file, "--clicks", source, "-o", out) == 2
    assert "clicks.csv" in capsys.readouterr().err and not out.exists()


def test_calibrate_and_refusals(tmp_path, capsys) -> None:
    rng = np.random.default_rng(1)
    images = []
    for i in range(5):
        yaw = rng.uniform(-30, 30)
        eye = (0.25 - 1.7 * np.tan(np.radians(yaw)), -1.7, rng.uniform(1.1, 1.5))
        view = Scene(Lens(), eye, yaw, rng.uniform(-8, 8), 20.0 * i)
        path = tmp_path / f"view{i}.png"
        cv2.imwrite(str(path), picture(view, 6, 4, 0.1, 1.5, samples=2))
        images.append(path)
    odd = tmp_path / "odd.png"
    cv2.imwrite(str(odd), np.full((481, 641), 90, np.uint8))
    out = tmp_path / "camera.json"
    assert run("calibrate", *images, odd, *BOARD, "-o", out, "--json") == 0
    printed = json.loads(capsys.readouterr().out)
    document = json.loads(out.read_text())
    assert {k: printed[k] for k in document} == document
    assert document["views"][-1]["used"] is False and document["views"][-1]["reason"]
    assert printed["trusted"] is False and printed["warnings"]
    assert run("calibrate", *images[:2], *BOARD, "-o", tmp_path / "no.json") == 2
    assert not (tmp_path / "no.json").exists()
    for bad in ("6", "6x", "1x4", "axb"):
        assert run("calibrate", *images, "--board", bad, "--square", 0.1, "-o", tmp_path / "no.json") == 2
    text = tmp_path / "text.png"
    text.write_text("hello")
    assert run("calibrate", text, *BOARD, "-o", tmp_path / "no.json") == 2
    assert "text.png" in capsys.readouterr().err
    assert run("calibrate", *images, *BOARD, "-o", tmp_path / "absent" / "camera.json") == 2


def tracks(path: Path, *pictures: list[np.ndarray]) -> Path:
    """A lossless clip with a video track for each list of grey pictures, and a sound track before them."""
    with closing(av.open(str(path), "w")) as out:
        sound = out.add_stream("aac", rate=44100)
        streams = []
        for shown in pictures:
            stream = out.add_stream("libx264", rate=25)
            stream.height, stream.width = shown[0].shape
            stream.pix_fmt, stream.options = "yuv420p", {"preset": "ultrafast", "qp": "0"}
            stream.disposition = av.stream.Disposition.default  # else the second would be switched off
            streams.append(stream)
        for stream, shown in zip(streams, pictures, strict=True):
            for n, gray in enumerate(shown):
                frame = av.VideoFrame.from_ndarray(np.repeat(gray[:, :, None], 3, axis=2), format="bgr24")
                frame.pts, frame.time_base = n, Fraction(1, 25)
                out.mux(stream.encode(frame))
            out.mux(stream.encode(None))
        silence = av.AudioFrame.from_ndarray(np.zeros((1, 1024), np.float32), format="fltp", layout="mono")
        silence.sample_rate, silence.pts = 44100, 0
        out.mux(sound.encode(silence))
        out.mux(sound.encode(None))
    return path


def test_calibrate_reads_the_track_that_is_asked_for(tmp_path, capsys) -> None:
    """Two cameras in one file: each track gives its own focal length, within its uncertainty."""
    lenses = Lens(f=260.0, cx=159.5, cy=119.5, width=320, height=240), Lens()
    seen: tuple[list, list] = ([], [])
    rng = np.random.default_rng(1)
    for i in range(6):
        yaw, pitch = rng.uniform(-30, 30), rng.uniform(-8, 8)
        eye = (0.25 - 1.7 * np.tan(np.radians(yaw)), -1.7, rng.uniform(1.1, 1.5))
        for shown, lens in zip(seen, lenses, strict=True):
            shown.append(picture(Scene(lens, eye, yaw, pitch, 20.0 * i), 6, 4, 0.1, 1.5, samples=2))
    clip, out = tracks(tmp_path / "two.mp4", *seen), tmp_path / "camera.json"
    for options, lens in (((), lenses[0]), (("--stream", 1), lenses[0]), (("--stream", 2), lenses[1])):
        assert run("calibrate", clip, *BOARD, "-o", out, *options) == 0, capsys.readouterr().err
        found = json.loads(out.read_text())
        assert (found["width_px"], found["height_px"]) == (lens.width, lens.height)
        assert [view["file"] for view in found["views"]] == [f"two.mp4 frame {n}" for n in range(6)]
        u_px = np.sqrt(found["covariance"][0][0])
        assert u_px < 0.1 * lens.f and abs(found["fx_px"] - lens.f) < 3 * u_px, found["fx_px"]
    out.unlink()
    capsys.readouterr()
    assert run("calibrate", clip, *BOARD, "-o", out, "--stream", 3) == 2
    assert "two.mp4 has no video track 3; it has 2, counted from 1." in capsys.readouterr().err
    still = tmp_path / "view.png"
    cv2.imwrite(str(still), seen[1][0])
    assert run("calibrate", still, clip, *BOARD, "-o", out, "--stream", 2) == 2
    assert "view.png is an image, not a video with tracks" in capsys.readouterr().err
    assert not out.exists()


def test_pose_reads_the_track_that_is_asked_for(camera_file, tmp_path, capsys) -> None:
    """Two cameras of one lens in one file, 1.4 and 1.9 m above the road: each track gives its own height."""
    higher = Scene(Lens(), (-0.4, -3.4, 1.9), 12.0, 10.0)
    seen = [
        [picture(scene, 6, 4, 0.1, 1.5, samples=4, seed=n) for n in range(3)] for scene in (SCENE, higher)
    ]
    clip, out = tracks(tmp_path / "two.mp4", *seen), tmp_path / "pose.json"
    given = ("--camera", camera_file, *BOARD, "--reference-height", 1.5, "-o", out)
    for options, scene in (((), SCENE), (("--stream", 1), SCENE), (("--stream", 2), higher)):
        assert run("pose", clip, *given, *options) == 0, capsys.readouterr().err
        found = json.loads(out.read_text())
        turn, shift = found["cam_from_road"]["rotation"], found["cam_from_road"]["translation_m"]
        assert -np.transpose(turn) @ shift == pytest.approx(scene.eye, abs=0.02)  # 0.3 m and more apart
        assert found["frames_used"] == 3
    out.unlink()
    capsys.readouterr()
    assert run("pose", clip, *given, "--stream", 3) == 2
    assert "two.mp4 has no video track 3" in capsys.readouterr().err
    still = tmp_path / "board.png"
    cv2.imwrite(str(still), seen[0][0])
    assert run("pose", still, *given, "--stream", 1) == 2
    assert "board.png is an image, not a video with tracks" in capsys.readouterr().err
    assert not out.exists()


def test_a_picture_given_twice_to_pose_counts_once(camera_file, still, tmp_path, capsys) -> None:
    """As two frames it would lose the warning that there is one alone."""
    copy, out = tmp_path / "copy.bmp", tmp_path / "pose.json"
    cv2.imwrite(str(copy), cv2.imread(str(still), cv2.IMREAD_UNCHANGED))
    given = ("--camera", camera_file, *BOARD, "--reference-height", 1.5, "-o", out, "--json")
    found = []
    for pictures in ((still,), (still, still, copy)):
        assert run("pose", *pictures, *given) == 0
        found.append(json.loads(capsys.readouterr().out))
    once, twice = found
    assert twice["frames_used"] == once["frames_used"] == 1 and twice["covariance"] == once["covariance"]
    same = f"is the same image as {still.name}; it counts once."
    assert twice["warnings"] == [f"{still.name} {same}", f"{copy.name} {same}", *once["warnings"]]


def test_frames_of_a_clip_that_were_given_before_are_counted_and_the_rest_is_used(tmp_path) -> None:
    seen = [picture(SCENE, 6, 4, 0.1, 1.5, samples=2, seed=n) for n in range(2)]
    clip, longer = tmp_path / "a.mp4", tmp_path / "b.mp4"
    tracks(clip, seen[:1])
    tracks(longer, seen)
    found, _, said = pose_detections((clip, longer, clip), camera_of(Lens()), Board(6, 4, 0.1))
    assert [str(one) for one in said] == [
        "1 frame of b.mp4 was given before; it counts once.",
        "1 frame of a.mp4 was given before; it counts once.",
    ]
    assert len(found) == 2


def test_pose_refusals(camera_file, still, tmp_path, capsys) -> None:
    small = tmp_path / "small.png"
    cv2.imwrite(str(small), np.full((240, 320), 90, np.uint8))
    out = tmp_path / "no.json"
    for picture_file, words in ((small, "320x240"), (tmp_path / "absent.mp4", "absent.mp4")):
        given = ("--camera", camera_file, *BOARD, "--reference-height", 1.5, "-o", out)
        assert run("pose", picture_file, *given) == 2
        assert words in capsys.readouterr().err
    assert run("pose", still, "--camera", still, *BOARD, "--reference-height", 1.5, "-o", out) == 2
    assert not out.exists()


def test_pictures_of_one_name_are_told_apart(still, tmp_path, capsys) -> None:
    (tmp_path / "other").mkdir()
    other = tmp_path / "other" / still.name
    other.write_bytes(still.read_bytes())
    seen = calibration_views([still, other, still], Board(6, 4, 0.1))
    assert run("calibrate", still, other, still, *BOARD, "-o", tmp_path / "camera.json") == 2
    assert "board.png (2)" in capsys.readouterr().err
    assert all(corners.found and size == (640, 480) for _, corners, size in seen)


def test_an_imported_camera_of_our_own_keeps_its_covariance(tmp_path, camera_file, capsys) -> None:
    lens = json.loads(camera_file.read_text())
    for covariance, said in ((np.eye(9).tolist(), "with its covariance"), (None, "no covariance")):
        given = {**lens, "covariance": covariance}
        camera_file.write_text(json.dumps(given))
        assert run("import-camera", camera_file, "-o", tmp_path / "out.json") == 0
        assert said in capsys.readouterr().out
        assert json.loads((tmp_path / "out.json").read_text())["covariance"] == covariance


def test_import_and_plan(tmp_path, capsys) -> None:
    source, out = tmp_path / "cam.yaml", tmp_path / "cam.json"
    source.write_text(
        "cam0:\n  camera_model: pinhole\n  intrinsics: [483.5, 483.5, 319.5, 239.5]\n"
        "  distortion_model: radtan\n  distortion_coeffs: [-0.3, 0.1, 0, 0]\n  resolution: [640, 480]\n"
    )
    assert run("import-camera", source, "-o", out) == 0
    assert json.loads(out.read_text())["fx_px"] == 483.5
    capsys.readouterr()
    assert run("plan", "--camera", out, "--camera-height", 1.5, "--distance", 3, "--json") == 0
    planned = json.loads(capsys.readouterr().out)
    eye = next(t for t in planned["targets"] if t["target"] == "driver_eye")
    assert eye["bias_if_ignored_m"] == pytest.approx((1.5 - 1.15) * 0.45 / 3.45)
    assert 0.008 < eye["u_height_m"] < 0.03 and planned["advice"]
    assert eye["two_frames"]["u_height_m"] < eye["u_height_m"]
    assert {"driver_eye", "driver_eye_far"} <= {t["target"] for t in planned["targets"]}
    curve = next(c for c in planned["U95_over_distance"] if c["target"] == "driver_eye")
    here = next(p for p in curve["points"] if p["distance_m"] == 3.0)
    assert here["U95_height_m"] == pytest.approx(eye["U95_height_m"])
    assert run("plan", "--camera", out, "--camera-height", -1, "--distance", 3) == 2
    assert run("plan", "--camera", out, "--camera-height", 1.5, "--distance", 3) == 0
    source.write_text("nothing")
    assert run("import-camera", source, "-o", out) == 2
    assert "cam.yaml" in capsys.readouterr().err


def test_plan_of_a_line_scan(capsys) -> None:
    rig = ("--baseline", 1, "--speed", 120 / 3.6, "--speed-error", 0.01)
    assert run("plan", *rig, "--json") == 0
    planned = json.loads(capsys.readouterr().out)
    assert planned["wanted"]["printed_right_side_hz"] == pytest.approx(6600)
    assert planned["wanted"]["corrected_hz"] == pytest.approx(20000 / 3) and planned["advice"]
    assert run("plan", *rig, "--line-rate", 3000, "--u-baseline", 0.002) == 0
    said = capsys.readouterr().out
    assert "90.0 lines" in said and "u of the speed, registering and baseline: 0.0670 m/s" in said
    for wrong in (
        (*rig, "--camera-height", 1.5),
        ("--baseline", 1),
        (*rig, "--line-rate", "nan"),
        (*rig, "--line-rate", "1e300"),
        ("--baseline", "1e300", *rig[2:]),
        ("--baseline", 1, "--speed", "1e300", "--speed-error", 0.01),
        ("--speed", 30),
        ("--camera-height", 1.5),
    ):
        assert run("plan", *wrong) == 2


def test_halves_of_millimetres_are_rounded_as_on_the_page_of_the_plan() -> None:
    assert [_mm(metres) for metres in (0.0125, 0.0135, 0.00251, None)] == ["13", "14", "3", "-"]


def test_plan_without_a_calibration(capsys) -> None:
    site = ("--camera-height", 1.5, "--distance", 3)
    assert run("plan", "--size", "640x480", "--field-of-view", 67, *site) == 0
    assert "driver_eye_far" in capsys.readouterr().out
    assert run("plan", "--size", "640x480", *site) == 2
    assert "--field-of-view" in capsys.readouterr().err


def test_a_picture_of_a_telephone_is_called_one(tmp_path, capsys) -> None:
    path = tmp_path / "IMG_0001.HEIC"
    path.write_bytes(b"\x00\x00\x00\x18ftypheic\x00\x00\x00\x00mif1heic" + bytes(200))
    command = ["calibrate", str(path), "--board", "9x6", "--square", "0.1", "-o", str(tmp_path / "c.json")]
    assert main(command) == 2
    said = capsys.readouterr().err
    assert "is a HEIC or AVIF image" in said and "PNG or JPEG" in said and "video" not in said
