"""Give records the identity that the code which measured them has by the new rule; run once, and then removed.

A record keeps it only if it was fresh by the old rule at the commit before, as that commit's ``make status`` said, which
is given as a file. The code was compared definition by definition: all 38 sections reach the same ones as before, word
for word, but for class Conditions, whose first half is in the generator now. Rows and traces stay the same bytes.
"""

import json
import re
import sys
from dataclasses import asdict
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
sys.path[:0] = [str(ROOT), str(ROOT / "packages/measured-report"), str(ROOT / "packages/newton-lint")]

from experiments.facts.clip_record import clips_identity
from measured_report.editions.project import Project
from measured_report.records.identity import identity_of

fresh = set()
head, *lines = Path(sys.argv[1]).read_text().splitlines()
releases = re.findall(r"newton (\S+)", head)
for line in lines:
    name, *states = re.split(r"\s{2,}", line.strip())
    if len(states) == len(releases):
        fresh |= {(release, name) for release, state in zip(releases, states, strict=True) if state == "fresh"}
changed = 0
for path in sorted((ROOT / "results").glob("newton-*/*.json")):
    release, section = path.parent.name.removeprefix("newton-"), path.stem
    if (release, section) not in fresh and section != "clips":
        print("stays as it is:", release, section)
        continue
    text = path.read_text(encoding="utf-8")
    record = json.loads(text)
    if section == "clips":
        found = clips_identity(Project(release, root=ROOT))
    else:
        found = identity_of(section, "full", ROOT, record["identity"]["packages"])
    start, end = text.index(' "identity": {'), text.index(',\n "machine": {')
    inner = json.dumps({"identity": asdict(found)}, indent=1, ensure_ascii=False)
    new = text[:start] + inner.removeprefix("{\n").removesuffix("\n}") + text[end:]
    after = json.loads(new)
    assert {**after, "identity": 0} == {**record, "identity": 0}
    assert new[new.index(',\n "machine": {') :] == text[end:]
    path.write_text(new, encoding="utf-8")
    changed += 1
print(changed, "records")
