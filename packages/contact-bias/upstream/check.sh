#!/bin/sh
# check.sh [MUJOCO_WARP [NEWTON]]: apply the patches to the released packages and write the results to checked.json.
# The script runs upstream's pre-commit hooks on the changed files, the tests before and after, and the engine's scenes.
# MUJOCO_WARP and NEWTON are checkouts to clone instead of those on GitHub.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
git clone -q --depth 1 "${1:-https://github.com/google-deepmind/mujoco_warp}" warp_repo
git clone -q --depth 1 "${2:-https://github.com/newton-physics/newton}" newton_repo
python3 -m venv env
env/bin/pip install -q newton==1.8.0 mujoco==4.0.0 mujoco-warp==4.0.0 warp-lang==1.19.0 absl-py etils pytest towncrier typos
env/bin/pip install -q --target ruff-0.14.14 ruff==0.14.14  # the version of MuJoCo Warp's pre-commit
env/bin/pip install -q --target ruff-0.15.20 ruff==0.15.20  # the version of Newton's pre-commit
python="$work/env/bin/python"
site=$("$python" -c "import sysconfig; print(sysconfig.get_path('purelib'))")
for tree in before after; do
  mkdir "$tree"
  cp -r "$site/mujoco_warp" "$site/newton" "$tree"
done

cd after
for patch in mujoco_warp-4.0.0-plane-capsule mujoco_warp-4.0.0-equality mujoco_warp-4.0.0 newton-1.8.0; do
  patch -p1 --fuzz=0 --input="$here/$patch.patch"
done
engine=$(sed -n 's|^+++ b/\(.*\.py\)$|\1|p' "$here"/mujoco_warp-*.patch | sort -u)
own=$(sed -n 's|^+++ b/\(.*\.py\)$|\1|p' "$here/newton-1.8.0.patch")
cp --parents $engine ../warp_repo
cp --parents -r $own changelog ../newton_repo
cd ../warp_repo
PYTHONPATH=../ruff-0.14.14 "$python" -m ruff check $engine
PYTHONPATH=../ruff-0.14.14 "$python" -m ruff format --check $engine
"$python" contrib/kernel_analyzer/kernel_analyzer/cli.py $engine
cd ../newton_repo
PYTHONPATH=../ruff-0.15.20 "$python" -m ruff check $own
PYTHONPATH=../ruff-0.15.20 "$python" -m ruff format --check $own
"$python" scripts/check_warp_array_syntax.py $own
../env/bin/typos $own changelog
../env/bin/towncrier build --draft --version 1.9.0 --date 2026-01-01 | grep use_contact_jdotv

cd "$work"
run() {  # run TREE NAME PYTEST-ARGUMENTS: write the results to NAME.xml; --pyargs finds the tree's package
  PYTHONPATH="$work/$1" "$python" -m pytest -q -p no:cacheprovider --junitxml="$2.xml" --pyargs $3 || echo "$2: failed"
}
for tree in before after; do
  run "$tree" "own_$tree" "mujoco_warp._src.constraint_test mujoco_warp._src.forward_test -k not(test_jdotv_forward)and(not(test_contact_jdotv))"
done
run after new.constraint_test.test_jdotv_forward "mujoco_warp._src.constraint_test -k test_jdotv_forward"
run after new.constraint_test.test_contact_jdotv "mujoco_warp._src.constraint_test -k test_contact_jdotv"
run after new.test_mujoco_contact_jdotv newton.tests.test_mujoco_contact_jdotv

cat >scenes.py <<'END'
"""Step the scenes of the engine's benchmarks that its package has, on a CPU, which mjwarp-testspeed refuses."""
import json, sys
import mujoco, mujoco_warp
from mujoco_warp._src.io import override_model
SCENES = {"humanoid/humanoid.xml": (24, 64), "humanoid/n_humanoid.xml": (100, 192), "aloha_pot/scene.xml": (24, 128)}
found = {}
for scene, (nconmax, njmax) in SCENES.items():
    model = mujoco.MjModel.from_xml_path(f"{mujoco_warp.__path__[0]}/test_data/{scene}")
    state = mujoco.MjData(model)
    mujoco.mj_resetDataKeyframe(model, state, 0)
    m = mujoco_warp.put_model(model)
    d = mujoco_warp.put_data(model, state, nworld=8, nconmax=nconmax, njmax=njmax)
    override_model(m, sys.argv[2:])
    for _ in range(200):
        mujoco_warp.step(m, d)
    found[scene] = d.qpos.numpy().tolist()
json.dump(found, open(sys.argv[1], "w"), allow_nan=False)
END
PYTHONPATH=before "$python" scenes.py before.json
PYTHONPATH=after "$python" scenes.py off.json
PYTHONPATH=after "$python" scenes.py on.json opt.contact_jdotv=True

"$python" - "$here" <<'END'
import datetime, hashlib, importlib.metadata, json, pathlib, sys, xml.etree.ElementTree as xml
here = pathlib.Path(sys.argv[1])

def counts(name):
    cases = list(xml.parse(f"{name}.xml").getroot().iter("testcase"))  # no subtests
    skipped = sum(case.find("skipped") is not None for case in cases)
    failed = sum(case.find("failure") is not None or case.find("error") is not None for case in cases)
    found = {"passed": len(cases) - skipped - failed, "skipped": skipped, "failed": failed}
    return {key: value for key, value in found.items() if value}

before, off, on = (json.load(open(f"{name}.json")) for name in ("before", "off", "on"))
checked = {
    "date": str(datetime.date.today()),
    "packages": [f"{name}=={importlib.metadata.version(name)}" for name in ("mujoco-warp", "mujoco", "newton", "warp-lang", "numpy")],
    "patches": {file.name: hashlib.sha256(file.read_bytes()).hexdigest() for file in sorted(here.glob("*.patch"))},
    "hooks": ["ruff 0.14.14", "kernel-analyzer", "ruff 0.15.20", "check-warp-array-syntax", "typos", "towncrier"],
    "own_before": counts("own_before"),
    "own_after": counts("own_after"),
    "new": {name[4:]: counts(name) for name in sorted(file.stem for file in pathlib.Path().glob("new.*.xml"))},
    "scenes": list(on),
    "same_when_off": before == off != on,
}
(here / "checked.json").write_text(json.dumps(checked, indent=1) + "\n")
END
