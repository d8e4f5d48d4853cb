EXTRA_DIST += docs/architecture.md docs/building.md docs/scene.md
