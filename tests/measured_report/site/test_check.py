"""The check of a site: what it finds in pages, numbers and links."""

from measured_report.site.check import check_site

SOURCE = "newton-1.4.0/toy.json#/rows"
WRONG = [
    (">0.31<", ">0.32<", "is shown"),
    (">0.31<", ">0.312<", "is shown"),
    ('value="0.3124"', 'value="0.31"', "is shown"),
    ("#/rows/1/slip_mm", "#/rows/9/slip_mm", "resolves to nothing"),
    ('href="data/values.json"', 'href="data/other.json"', "leads nowhere"),
    ('href="data/values.json"', 'href="/data/values.json"', "leaves the site"),
    ('href="#toy"', 'href="#other"', "leads nowhere"),
    ("</main>", '<script src="x.js"></script></main>', "leads nowhere"),
    ("</main>", '<a href="javascript:alert(1)">x</a></main>', "no address that a page may lead to"),
    ("default-src 'none'", "default-src *", "no policy"),
    ('data-outcome="holds"', "", "no outcome"),
    ("data-claim", "data-other", "there is no claim"),
    ("</main>", '<p id="toy"></p></main>', "not unique"),
]
SLIP = f'<data value="0.3124" data-src="{SOURCE}/1/slip_mm"%s>%s</data>'
NEAREST, MOST, LEAST = SLIP % ("", "0.31"), SLIP % (' data-as="most"', "0.32"), SLIP % (' data-as="least"', "0.31")
BOUNDS = [(f"{words} {NEAREST}", True) for words in ("At most", "within", "no more than", "less than")]
BOUNDS += [(f"within <b>a factor of {NEAREST}</b>", True), (f"{NEAREST}&nbsp;mm at most", True)]
BOUNDS += [
    (f"{words} {MOST}", False) for words in ("at most", "within", "no more than", "less than", "none is more than")
]
BOUNDS += [(f"{words} {LEAST}", False) for words in ("at least", "more than", "no run of 1.5 has less than")]
BOUNDS += [(f"{words} {MOST}", True) for words in ("at least", "more than")]
BOUNDS += [(f"It is no slip. More than {NEAREST}", False), (f"it never slips more than {NEAREST}", True)]


def test_what_is_wrong_is_found(toy):
    toy.build()
    assert check_site(toy.project.site) == []
    page = toy.page
    for old, new, problem in WRONG:
        assert old in page
        toy.page_path.write_text(page.replace(old, new), encoding="utf-8")
        found = check_site(toy.project.site)
        assert any(problem in line for line in found), new


UNREADABLE = {"index.html": b"\xff", "data/newton-1.4.0/toy.json": b"[" * 100_000, "data/values.json": b"null"}


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


def test_no_bound_errs_against_its_own_value(toy):
    toy.build()
    page = toy.page
    for words, errs in BOUNDS:
        toy.page_path.write_text(page.replace("</main>", f"<p>{words}</p></main>"), encoding="utf-8")
        assert [line for line in check_site(toy.project.site) if "errs: it is 0.3124" in line] or not errs, words
        assert errs or check_site(toy.project.site) == [], words
