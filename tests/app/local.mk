# Tests of the whole program: bash scripts, started by tests/launch.

EXTRA_DIST += tests/app/common.sh
dist_check_SCRIPTS += tests/app/ablate.sh tests/app/bad_input.sh tests/app/folder.sh tests/app/guards.sh tests/app/hard.sh tests/app/layouts.sh tests/app/needs.sh tests/app/pack.sh tests/app/physics.sh tests/app/restart.sh

dist_check_SCRIPTS += tests/app/ranks.sh

dist_check_SCRIPTS += tests/app/verify.sh

dist_check_SCRIPTS += tests/app/reproducible.sh
