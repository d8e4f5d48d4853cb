EXTRA_DIST += docs/building.md
