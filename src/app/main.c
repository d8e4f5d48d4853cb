#include "scree.h"

int main(int argc, char **argv) {
    return scree_main(argc, argv);
}
