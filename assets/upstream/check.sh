#!/bin/sh
# check.sh PYTHON [MUJOCO_WARP]: apply the patches to a copy of the packages that PYTHON has, and run the tests; with a
# checkout of MuJoCo Warp its kernel analyzer too, as its pre-commit does.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
python=$1
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
site=$("$python" -c "import sysconfig; print(sysconfig.get_path('purelib'))")
cp -r "$site/mujoco_warp" "$site/newton" "$folder"
cd "$folder"
export PYTHONPATH="$folder"
for patch in mujoco_warp-4.0.0-equality mujoco_warp-4.0.0 newton-1.8.0; do
  patch -p1 --fuzz=0 --input="$here/$patch.patch"
done
if [ $# -gt 1 ]; then
  "$python" "$2/contrib/kernel_analyzer/kernel_analyzer/cli.py" mujoco_warp/_src/contact_jdotv.py mujoco_warp/_src/forward.py
fi
for tests in constraint forward contact_jdotv; do
  "$python" -m "mujoco_warp._src.${tests}_test" || echo "$tests: failed"
done
"$python" -m unittest newton.tests.test_mujoco_contact_jdotv
