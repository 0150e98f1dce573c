"""All data in one file: what it holds, and that it is the same again."""

from zipfile import ZipFile

from measured_report.site.check import check_site
from measured_report.site.data import rows_csv

FOLDER = "shake-report-data/"


def test_finding_8_no_text_of_a_table_is_a_formula():
    rows = [{"case": "=1+1", "said": "-x", "slip_mm": -1.5}, {"case": "@a", "said": "-1.5", "slip_mm": None}]
    rows += [{"case": "＝1+1", "said": "\n=1+1", "slip_mm": 1.0}]
    assert rows_csv(rows).split("\n", 3)[1:] == ["'=1+1,'-x,-1.5", "'@a,'-1.5,", "'＝1+1,\"'\n=1+1\",1.0\n"]


def test_the_archive_holds_records_and_values_and_is_the_same_again(toy):
    toy.build()
    with ZipFile(toy.project.site / "data.zip") as archive:
        files = {name.removeprefix(FOLDER): archive.read(name) for name in archive.namelist()}
    named = {f"newton-1.4.0/{name}" for name in ("toy.json", "toy.csv", "toy.stiff.csv.gz")}
    assert set(files) == {"README.txt", "values.json", *named}
    assert files["newton-1.4.0/toy.json"] == toy.record_path.read_bytes()
    assert files["values.json"] == (toy.project.site / "data/values.json").read_bytes()
    assert 'href="data.zip"' in toy.page and check_site(toy.project.site) == []
    first = (toy.project.site / "data.zip").read_bytes()
    toy.record_path.touch()
    toy.build()
    assert (toy.project.site / "data.zip").read_bytes() == first
