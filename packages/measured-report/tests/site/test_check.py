"""Test that the check of a site finds errors of pages, numbers and links."""

from measured_report.site.check import check_site

ADDRESSES = (
    "javascript:alert(1)",
    "JaVaScRiPt:alert(1)",
    " java\nscript:alert(1)",
    "\x01javascript:alert(1)",
    "vbscript:x",
)
ADDRESSES += (
    "data:text/html,x",
    "file:///etc/passwd",
    "ftp://example.org",
    "blob:x",
    "http://[",
)
WRONG = [
    (">0.31<", ">0.32<", "the page shows"),
    (">0.31<", ">0.313<", "the page shows"),
    ('value="0.3124"', 'value="0.31"', "the page shows"),
    ("#/rows/1/slip_mm", "#/rows/9/slip_mm", "does not point to a number"),
    ('href="data/values.json"', 'href="data/other.json"', "does not exist"),
    ('href="data/values.json"', 'href="/data/values.json"', "leaves the site"),
    ('href="#toy"', 'href="#other"', "does not exist"),
    ("</main>", '<script src="x.js"></script></main>', "does not exist"),
    (
        "</main>",
        '<script src="https://example.org/x.js"></script></main>',
        "fetched from another site",
    ),
    (
        "</main>",
        '<script src="data/values.json"></script></main>',
        "not the project's own",
    ),
    ("</main>", '<script src="page.js" onload="x"></script></main>', "runs a script"),
    ("</main>", "<script>alert(1)", "not the project's own"),
    ("</main>", "<script>alert(1)</script></main>", "not the project's own"),
    ("</main>", "<script></script></main>", "not the project's own"),
    (
        "</main>",
        '<img src="https://example.org/x.png" alt=""></main>',
        "fetched from another site",
    ),
    ('href="style.css"', 'href="//example.org/style.css"', "fetched from another site"),
    ("</main>", "<style>@import 'x'</style></main>", "style fetches"),
    ('data-outcome="holds"', "", "does not have an outcome"),
    ("data-claim", "data-other", "there is no claim"),
    ("</main>", '<p id="toy"></p></main>', "not unique"),
    *(
        (
            "</main>",
            f'<a href="{to}">x</a></main>',
            "is not allowed",
        )
        for to in ADDRESSES
    ),
    ("</main>", '<iframe src="x"></main>', "runs a script"),
    ("</main>", "<form></main>", "runs a script"),
    ("</main>", '<base href="."></main>', "runs a script"),
    ("</main>", '<meta http-equiv="Refresh"></main>', "runs a script"),
]


def test_what_is_wrong_is_found(toy):
    toy.build()
    assert check_site(toy.project.site) == []
    page = toy.page
    for old, new, problem in WRONG:
        assert old in page
        toy.page_path.write_text(page.replace(old, new), encoding="utf-8")
        found = check_site(toy.project.site)
        assert any(problem in line for line in found) if problem else found == [], new


def test_a_picture_that_is_empty_or_another_file_is_found(toy):
    toy.build()
    page = toy.page.replace("</main>", '<img src="x.PNG" alt="x"></main>')
    toy.page_path.write_text(page, encoding="utf-8")
    picture = toy.project.site / "x.PNG"
    problem = f"{toy.page_path.name}: x.PNG is not such a picture: save it again"
    for content, problems in {
        b"": [problem],
        b"<html>": [problem],
        b"\x89PNG\r\n": [],
    }.items():
        picture.write_bytes(content)
        assert check_site(toy.project.site) == problems


UNREADABLE = {
    "index.html": b"\xff",
    "style.css": b"\xff",
    "data/newton-1.4.0/toy.json": b"[" * 100_000,
    "data/values.json": b"null",
}


def test_what_can_not_be_read_is_said_in_one_line(toy):
    toy.build()
    for name, content in UNREADABLE.items():
        path = toy.project.site / name
        before = path.read_bytes()
        path.write_bytes(content)
        problems = check_site(toy.project.site)
        assert problems and not any("\n" in problem for problem in problems), name
        path.write_bytes(before)
    assert check_site(toy.project.site) == []
