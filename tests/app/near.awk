# SPDX-License-Identifier: BSD-3-Clause
# awk -f near.awk A B: the same words in the same places, and numbers that differ by less than 1e-9. Line 1 is a title.
FNR == NR { line[FNR] = $0; lines = FNR; next }
FNR > 1 {
    if (split(line[FNR], was) != NF)
        bad = FNR
    for (k = 1; k <= NF; k++)
        if ($k != was[k] && !($k - was[k] < 1e-9 && was[k] - $k < 1e-9 && $k + 0 != 0))
            bad = FNR
}
END { if (bad || FNR != lines) { print "  line " bad; exit 1 } }
