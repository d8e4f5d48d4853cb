# SCREE_PYTHON
# Looks for a Python that has what the package scree needs: cffi and numpy, pandas for its tables and pytest for its
# tests. Sets PYTHON (empty: none), python_said and python_lacks, what is missing of the rest.
AC_DEFUN([SCREE_PYTHON], [
AC_ARG_VAR([PYTHON], [Python with cffi and numpy, for the package scree and its tests])
scree_pythons=${PYTHON:-"python3 /usr/bin/python3"}
PYTHON=
python_lacks=
AC_MSG_CHECKING([for a Python with cffi and numpy])
for candidate in $scree_pythons; do
    AS_IF([test -z "$PYTHON" && $candidate -c 'import cffi, numpy' >/dev/null 2>&1],
          [PYTHON=`$candidate -c 'import sys; print(sys.executable)'`])
done
AS_IF([test -n "$PYTHON"],
      [for module in pandas pytest; do
           $PYTHON -c "import $module" >/dev/null 2>&1 || python_lacks="$python_lacks $module"
       done
       python_said="$PYTHON${python_lacks:+ (missing:$python_lacks)}"],
      [python_said="no (missing: cffi, numpy; Debian: python3-cffi python3-numpy python3-pandas python3-pytest)"])
AC_MSG_RESULT([$python_said])
])
