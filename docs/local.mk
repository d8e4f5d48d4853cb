EXTRA_DIST += docs/architecture.md docs/building.md docs/scene.md
EXTRA_DIST += docs/indexes.md docs/images/penetration.png
EXTRA_DIST += docs/physics.md
EXTRA_DIST += docs/hard-cases.md
