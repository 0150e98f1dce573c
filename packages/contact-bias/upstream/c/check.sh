#!/bin/sh
# check.sh [MUJOCO]: compile only MuJoCo's engine, with and without the patch, and run the box scene of upstream.md.
# It needs gcc and libccd-dev. MUJOCO is a checkout with the tag 3.12.0 to use instead of GitHub's.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
repo=${1:-repo}
[ $# -gt 0 ] || git clone -q --depth 1 --branch 3.12.0 https://github.com/google-deepmind/mujoco repo
python3 -m venv env
env/bin/pip install -q mujoco==3.12.0
cat >run.c <<'END'
#include <mujoco/mujoco.h>
#include <stdio.h>
#include <stdlib.h>
long mju_writeResource_stub(void) __asm__("mju_writeResource");
long mju_writeResource_stub(void) { return -1; }  // This is part of the parser, which is not compiled.
int main(int count, char** arguments) {
  static char buffer[1 << 24];
  mjModel* m = mj_loadModelBuffer(buffer, fread(buffer, 1, sizeof buffer, stdin));
  m->opt.enableflags |= atoi(arguments[1]);
  mjData* d = mj_makeData(m);
  mj_resetDataKeyframe(m, d, 0);
  for (int i = 0; i < 500; i++) mj_step(m, d);
  for (int i = 0; i < m->nq; i++) printf("%.17g ", d->qpos[i]);
}
END
for tree in before after; do
  mkdir -p $tree/objects
  git -C "$repo" archive 3.12.0 include src/engine | tar x -C $tree
  [ $tree = before ] || patch -s -p1 -d $tree --fuzz=0 --input="$here/mujoco-3.12.0.patch"
  for file in run.c $tree/src/engine/*.c $tree/src/engine/*.cc; do
    case $file in *.cc) compile="g++ -std=c++20" ;; *) compile="gcc -std=c11 -D_GNU_SOURCE" ;; esac
    echo "$compile -O3 -mavx -w -I$tree/include -I$tree/src -c $file -o $tree/objects/$(basename "$file").o"
  done | xargs -P "$(nproc)" -I{} sh -c "{}"
  g++ $tree/objects/*.o -o $tree/run -lccd -lm -ldl -lpthread
done
env/bin/python - "$here/../upstream.md" <<'END'
import re, subprocess, sys
import mujoco, numpy as np
JDOTV = 64
xml = re.search(r'from_xml_string\("""(.*?)"""', open(sys.argv[1]).read(), re.DOTALL).group(1)
for cone in "elliptic", "pyramidal":
    model = mujoco.MjModel.from_xml_string(xml.replace("elliptic", cone))
    mujoco.mj_saveModel(model, "model.mjb", None)
    def run(tree, flag):
        done = subprocess.run([f"{tree}/run", str(flag)], stdin=open("model.mjb"), capture_output=True, check=True)
        return np.array(done.stdout.split(), float)
    data = mujoco.MjData(model)
    mujoco.mj_resetDataKeyframe(model, data, 0)
    for _ in range(500):
        mujoco.mj_step(model, data)
    off, on = run("after", 0), run("after", JDOTV)
    same = np.array_equal(run("before", 0), off) and np.array_equal(data.qpos, off)
    walks = [f"{1e3 * (np.hypot(*q[1:3]) - 0.2):.3f} mm" for q in (off, on)]
    print(f"{cone}: off as the release to the last bit: {same}; the box walks by {walks[0]}, with the flag by {walks[1]}")
END
