/* Makes the tables of a page anew: make src/output/document && src/output/document <docs/output.md >new */
#include "output/describe.h"

int main(void) {
    struct error error = {0};
    if (!describe_page(stdin, stdout, &error))
        fprintf(stderr, "%s\n", error.text);
    return fflush(stdout) != 0 || error.kind != ERROR_NONE;
}
