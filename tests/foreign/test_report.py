"""The program's report against what the quaternion form and the files say."""

import pytest

from conftest import ROOT


def test_report_measures_the_curves(built):
    report = built.report()
    assert list(report["objects"]) == list(built.objects)
    for name, reference in built.objects.items():
        entry = report["objects"][name]
        assert set(entry) >= {"type", "length", "pieces", "closed", "joints", "curvature", "weights", "warnings"}
        assert entry["type"] == reference.kind
        assert entry["weights"]["min"] > 0.0
        if reference.curves is None:
            continue
        assert entry["length"] == pytest.approx(sum(c.length() for c in reference.curves), rel=1e-9)
        assert entry["closed"] == all(c.closed for c in reference.curves)
        assert entry["joints"]["gap"] == 0.0, "pieces meet to the bit"
        if reference.kind != "arc" and not any(reference.corners):
            assert entry["joints"]["angle"] < 1e-7, name
        if all(type(p).__name__ == "Arc" for c in reference.curves for p in c.pieces):
            tightest = max(1.0 / p.radius() for c in reference.curves for p in c.pieces)
            assert entry["curvature"]["max"] == pytest.approx(tightest, rel=1e-9)


@pytest.mark.parametrize("suffix", ["step", "dxf", "svg", "csv", "json"])
def test_deviation_of_the_file_keeps_the_promise(built, suffix):
    entry = built.file_report(suffix)
    assert entry["format"] == suffix
    sizes = [c.extent() for r in built.objects.values() for c in r.curves or []]
    rounding = 1e-12 * max(sizes, default=1e3) + 1e-12
    assert entry["exact"] == (entry["bound"] == 0.0)
    assert 0.0 <= entry["deviation"] <= entry["bound"] + rounding


CURVE_SUFFIXES = ("step", "dxf", "svg", "csv", "json", "png", "vtu", "mesh", "xml")
SURFACE_SUFFIXES = ("step", "glb", "obj", "stl", "ply", "png", "svg", "json", "vtu", "mesh", "xml")
SAME = {name: CURVE_SUFFIXES for name in ("track", "logo", "cable")} | {name: SURFACE_SUFFIXES for name in ("handle", "roof")}


@pytest.mark.parametrize("name", SAME)
def test_the_same_input_gives_the_same_bytes(name, program, tmp_path):
    # The file's name may stand in its header: same names, other folders; each run is a process of its own.
    runs = [tmp_path / run for run in ("first", "again")]
    for folder in runs:
        folder.mkdir()
        outputs = [x for suffix in SAME[name] for x in ("-o", folder / f"{name}.{suffix}")]
        program("build", ROOT / "examples" / f"{name}.json", *outputs)
    for suffix in SAME[name]:
        first, again = (folder / f"{name}.{suffix}" for folder in runs)
        assert first.stat().st_size > 0
        assert first.read_bytes() == again.read_bytes(), first.name


def test_a_failed_run_leaves_the_old_file(program, tmp_path):
    document, target = tmp_path / "bad.json", tmp_path / "old.step"
    document.write_text('{"cyclide": 1, "objects": {"a": {"type": "arc", "from": [0, 0], "to": [0, 0], "tangent": [1, 0]}}}')
    target.write_text("old")
    with pytest.raises(AssertionError, match="exit 1"):
        program("build", document, "-o", target)
    assert target.read_text() == "old"
    assert sorted(p.name for p in tmp_path.iterdir()) == ["bad.json", "old.step"]
