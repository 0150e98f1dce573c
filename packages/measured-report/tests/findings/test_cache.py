"""Test that a part of the site is built again only if one of its sources changed."""

import pickle
import shutil
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import pytest
from toys import MODULE, REPORT, ROWS, TEMPLATE, Toy, program

from measured_report.files.cache import Cache, _is_ours
from measured_report.findings import cache as derived
from measured_report.findings.editions import derive_edition, editions_of
from measured_report.pages.prose import GENERATOR
from measured_report.records import code
from measured_report.records.record import write_record
from measured_report.records.replicas import FOLDER

SECTION = """
from measured_report.parts.section import Section

order = {order}
page = "limits"
reads = {named}

def derive(results):
    with open({log!r}, "a") as log:
        log.write("{name} ")
    {reads}
    return Section()
"""
PACKAGE = Path(derived.__file__).parents[2]
READS = {
    "reader": 'results.value("twice", "twice the gain", lambda a: 2 * a, results.others["toy"].derived["gain"])',
    "alone": "",
}


def files(site: Path) -> dict[str, bytes]:
    return {
        str(path.relative_to(site)): path.read_bytes()
        for path in sorted(site.rglob("*"))
        if path.is_file()
    }


def from_nothing(toy: Toy) -> dict[str, bytes]:
    """Build the site without kept results."""
    shutil.rmtree(Cache(toy.project.root).folder)
    shutil.rmtree(toy.project.site)
    toy.build()
    return files(toy.project.site)


def rewritten(old: str, new: str) -> Callable[[Toy], None]:
    """Changes the template or the module of the toy."""
    assert old in TEMPLATE + MODULE

    def change(toy: Toy) -> None:
        toy.write("templates/sections/toy.md.j2", TEMPLATE.replace(old, new))
        toy.write("report/sections/toy.py", MODULE.replace(old, new))

    return change


EXTENDED = '{% extends "layout/base.html.j2" %}{% block subject %}A toy.{% endblock %}'
CHANGES: dict[str, Callable[[Toy], None]] = {
    "a word of a claim": rewritten("It helps", "It aids"),
    "what it derives": rewritten("a / b", "a / b + 1"),
    "a page": lambda toy: toy.write(
        "templates/pages/cause.md.j2", "# Other suspects\n"
    ),
    "a block of a layout": lambda toy: toy.write("templates/base.html.j2", EXTENDED),
    "a number": lambda toy: toy.measure([ROWS[0], {**ROWS[1], "slip_mm": 0.4}]),
    "its trace": lambda toy: toy.measure(end_mm=0.7),
    "the simulator's side": lambda toy: toy.write(
        "experiments/scene.py", "def slip():\n    return 2.0\n"
    ),
    "another release": lambda toy: toy.of("1.8.0").measure(),
}


@pytest.mark.parametrize("change", CHANGES)
def test_a_change_of_anything_is_seen(built, change):
    before = files(built.project.site)
    CHANGES[change](built)
    built.build()
    after = files(built.project.site)
    assert after != before
    assert after == from_nothing(built)


def test_a_module_that_the_section_imports_counts(toy):
    (toy.project.root / "report/sections/toy.py").unlink()
    module = "from report.sections.toy.label import LABEL\n" + MODULE.replace(
        'label="x"', "label=LABEL"
    )
    toy.write("report/sections/toy/__init__.py", module)
    toy.write("report/sections/toy/label.py", 'LABEL = "x"\n')
    toy.build()
    drawing = toy.page_path.parent / "figures/toy-way.svg"
    assert ">x</text>" in drawing.read_text()
    toy.write("report/sections/toy/label.py", 'LABEL = "y"\n')
    toy.build()
    assert ">y</text>" in drawing.read_text()
    assert ">x</text>" not in drawing.read_text()


@pytest.mark.parametrize("name", ["body.py", "scatter.py", "replicas.py"])
def test_the_code_that_evaluates_all_measurements_counts(toy, monkeypatch, name):
    """Test modules that no section imports although all claims depend on them."""

    def key() -> str:
        return derive_edition(toy.project).chapters["toy"].key

    def changed_source(path: Path, label: str) -> code.Source:
        source = read_source(path, label)
        return replace(source, digest="changed") if path.name == name else source

    before = key()
    read_source = code.read_source
    monkeypatch.setattr(code, "read_source", changed_source)
    assert key() != before


def test_what_is_installed_counts(monkeypatch):
    before = derived.installed.__wrapped__()
    monkeypatch.setattr(derived.metadata, "version", lambda name: "9.9")
    assert derived.installed.__wrapped__() != before


def with_readers(toy: Toy, order: int = 2) -> Path:
    """Write both modules, and return where each one records that it was derived."""
    log = toy.project.root / "log"
    for place, (name, reads) in enumerate(READS.items()):
        toy.write(f"experiments/{name}.py", "def measure(conditions): ...\n")
        toy.write(
            f"report/sections/{name}.py",
            SECTION.format(
                name=name,
                reads=reads,
                named=("toy",) if reads else (),
                order=order + 10 * place,
                log=str(log),
            ),
        )
        toy.write(
            f"templates/sections/{name}.md.j2",
            f"# Section {name}\n\n{{{{ rows[0].slip_mm }}}}\n",
        )
        measure(toy, name)
    return log


def measure(toy: Toy, name: str, slip_mm: float = 1.0) -> None:
    rows = [{"case": "one", "slip_mm": slip_mm}]
    write_record(toy.project.record_path(name), toy.record(rows, section=name), {})


def test_a_change_of_any_record_derives_again_whatever_has_numbers(toy):
    """Test that each record shows the scatter of all records."""
    log = with_readers(toy)

    def derived() -> list[str]:
        log.write_text("")
        toy.build()
        return sorted(log.read_text().split())

    toy.build()
    assert derived() == []
    measure(toy, "alone", 2.0)
    assert derived() == ["alone", "reader"]
    toy.write("templates/pages/cause.md.j2", "# Other suspects\n")
    assert derived() == []
    toy.record_path.unlink()
    assert derived() == ["alone", "reader"]
    toy.measure()
    assert derived() == [
        "alone"
    ]  # the function that reads the record failed, and its result is still stored
    assert files(toy.project.site) == from_nothing(toy)


def test_editions_that_are_derived_side_by_side_make_the_same_site(toy, monkeypatch):
    toy.of("1.8.0").measure()
    toy.build()
    side_by_side = from_nothing(toy)
    monkeypatch.setattr("os.sched_getaffinity", lambda _: {0})
    assert from_nothing(toy) == side_by_side


def test_records_and_replicas_of_all_editions_count(toy):
    with_readers(toy)
    replica = toy.project.results / FOLDER / "a.tgz"
    replica.parent.mkdir()

    def key() -> str:
        return derive_edition(toy.project).chapters["toy"].key

    changes = [
        lambda: measure(toy, "alone", 3.0),
        lambda: replica.write_bytes(b"damaged"),
        lambda: replica.write_bytes(b"damaged again"),
        lambda: toy.of("1.8.0").measure(),
        lambda: toy.of("1.8.0").measure([ROWS[0]]),
    ]
    keys = [key()]
    for change in changes:
        change()
        keys.append(key())
    assert key() == keys[-1]
    assert len(set(keys)) == len(keys)


def left_out(toy: Toy) -> dict[str, str]:
    [edition] = editions_of(toy.project).values()
    return {state.section: "; ".join(state.notes) for state in edition.left_out}


def test_a_section_reads_only_what_it_names_and_what_stands_before_it(toy):
    with_readers(toy, order=0)
    assert (
        "report/sections/reader.py reads toy, which comes after it"
        in left_out(toy)["reader"]
    )
    with_readers(toy, order=2)
    assert left_out(toy) == {}
    reader = toy.project.root / "report/sections/reader.py"
    toy.write(
        "report/sections/reader.py",
        reader.read_text().replace("reads = ('toy',)", "reads = ()"),
    )
    assert "report/sections/reader.py:11: KeyError: 'toy'" in left_out(toy)["reader"]


def test_a_site_that_was_altered_is_built_again(built):
    before = files(built.project.site)
    built.page_path.write_text("altered")
    (built.project.site / "more.html").write_text("more")
    (built.project.site / "style.css").unlink()
    built.build()
    assert files(built.project.site) == before


ENTRIES = ("site", "full.1.4.0.toy")
DAMAGE: dict[str, Callable[[Path], object]] = {
    "half": lambda path: path.write_bytes(
        path.read_bytes()[: path.stat().st_size // 2]
    ),
    "a folder": lambda path: (path.unlink(), path.mkdir()),
    "of another kind": lambda path: path.write_bytes(
        pickle.dumps("other") + pickle.dumps({"other": 1})
    ),
}


@pytest.mark.parametrize("damage", DAMAGE)
def test_an_entry_that_is_damaged_is_made_again(built, damage):
    before = files(built.project.site)
    cache = Cache(built.project.root).folder
    assert {path.name for path in cache.iterdir()} >= set(ENTRIES)
    for name in ENTRIES:
        DAMAGE[damage](cache / name)
    (built.project.root / "templates" / "unused.md.j2").write_text("new")
    built.build()
    assert files(built.project.site) == before


@pytest.mark.parametrize("base", ["", ".cache", "../cache"])
def test_a_cache_in_a_checkout_is_not_used(toy, monkeypatch, tmp_path, base):
    """Test a relative path and a missing one, which would both lead into the checkout."""
    monkeypatch.setenv("XDG_CACHE_HOME", base)
    monkeypatch.setenv("HOME", str(tmp_path / "home"))
    monkeypatch.chdir(toy.project.root)
    expected = tmp_path / "home/.cache/measured-report"
    assert Cache(toy.project.root).folder.parent == expected


def test_compiled_templates_are_kept_in_the_cache_and_not_where_others_may_write(
    toy, monkeypatch, tmp_path
):
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))
    monkeypatch.setattr("tempfile.tempdir", str(tmp_path / "nowhere"))
    toy.build()
    folder = Cache(GENERATOR).folder
    kept = {path.name: path.read_bytes() for path in folder.iterdir()}
    assert {name.partition("-")[0] for name in kept} == {"layout", "prose"}
    folder.chmod(0o777)
    _is_ours.cache_clear()
    for name in kept:
        (folder / name).write_bytes(pickle.dumps("from somebody else"))
    toy.write("templates/front.md.j2", "# Another title\n")
    toy.build()
    assert "Another title" in toy.front
    assert {*map(Path.read_bytes, folder.iterdir())} == {
        pickle.dumps("from somebody else")
    }
    _is_ours.cache_clear()


@pytest.mark.slow
def test_the_same_commit_gives_the_same_bytes_anywhere(toy, tmp_path):
    """Test builds in two folders, languages, time zones and orders of unordered files,
    and in a process that had other reports.
    """
    toy.build()
    sites = [files(toy.project.site)]
    shutil.rmtree(toy.project.site)
    for name, environment in {
        "a place": {
            "PYTHONHASHSEED": "1",
            "TZ": "UTC",
            "LC_ALL": "C",
            "HOME": str(tmp_path / "home"),
        },
        "ein Ört": {
            "PYTHONHASHSEED": "2",
            "TZ": "Asia/Kathmandu",
            "LC_ALL": "de_DE.UTF-8",
            "MPLBACKEND": "agg",
        },
    }.items():
        shutil.copytree(toy.project.root, tmp_path / name)
        environment["PYTHONPATH"] = str(
            PACKAGE
        )  # another report's modules may be there too
        assert (
            program("-c", REPORT, tmp_path / name, "1.4.0", **environment).returncode
            == 0
        )
        sites.append(files(tmp_path / name / "site"))
    assert len(sites[0]) > 10 and sites[0] == sites[1] == sites[2]


@pytest.mark.parametrize("mode", [0o720, 0o702])
def test_what_others_may_write_is_no_cache(tmp_path, monkeypatch, capsys, mode):
    """Test a folder that its group or other users can write to, or that belongs to
    somebody else.
    """
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    mine = Cache(tmp_path / "one")
    mine.put("a", 1, "value")
    assert mine.get("a", 1) == "value"
    assert capsys.readouterr().err == ""
    mine.folder.chmod(mode)
    _is_ours.cache_clear()
    assert (
        mine.get("a", 1) is None
        and "other users can write to it" in capsys.readouterr().err
    )
    mine.folder.chmod(0o700)
    monkeypatch.setattr("os.geteuid", lambda: mine.folder.stat().st_uid + 1)
    _is_ours.cache_clear()
    mine.put("b", 1, "value")
    assert not (mine.folder / "b").exists()
    _is_ours.cache_clear()
