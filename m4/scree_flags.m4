# SCREE_TRY_FLAGS(FLAGS)
# Appends those of FLAGS that the compiler takes to SCREE_CFLAGS.
AC_DEFUN([SCREE_TRY_FLAGS], [
for scree_flag in $1; do
    scree_save_CFLAGS=$CFLAGS
    CFLAGS="$CFLAGS -Werror $scree_flag"
    AC_MSG_CHECKING([whether $CC takes $scree_flag])
    AC_COMPILE_IFELSE([AC_LANG_SOURCE([[int main(void) { return 0; }]])],
                      [AC_MSG_RESULT([yes])
                       SCREE_CFLAGS="$SCREE_CFLAGS $scree_flag"],
                      [AC_MSG_RESULT([no])])
    CFLAGS=$scree_save_CFLAGS
done
])
