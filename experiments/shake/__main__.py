"""The shake test as a Newton example.

python -m experiments.shake --viewer gl
python -m experiments.shake --viewer null --pad-ke 2.5e5 --pad-kd 1e3 --test --json summary.json
"""

import sys

from experiments.shake.command import main

if __name__ == "__main__":
    sys.exit(main())
