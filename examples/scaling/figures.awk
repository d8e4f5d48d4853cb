# A line of JSON from a report.json; variables: head (keys of one's own, ready to print), cores (of the machine)
function each(text, n, k, part) { # mean and most of a list
    gsub(/[^0-9 ]/, "", text)
    n = split(text, part, " ")
    mean = most = 0
    for (k = 1; k <= n; k++) {
        mean += part[k] / n
        most = part[k] > most ? part[k] : most
    }
}
/^ *"[a-z_]+": / {
    key = $1
    gsub(/[":]/, "", key)
    text = $0
    sub(/^[^:]*: */, "", text)
    sub(/,$/, "", text)
    if (text ~ /^\[[0-9]/) {
        each(text)
        means[key] = mean
        mosts[key] = most
    } else if (match(text, /"mean": [-+.0-9e]+/)) {
        if (substr(text, RSTART + 8, RLENGTH - 8) > 0)
            stages = stages (stages ? ", " : "") "\"" key "\": " substr(text, RSTART + 8, RLENGTH - 8)
    } else if (!(key in number)) {
        number[key] = text
    }
}
END {
    steps = number["steps"]
    workers = number["ranks"] * number["threads"]
    used = workers < cores ? workers : cores
    if (!(number["seconds"] > 0 && steps > 0 && stages)) {
        print "report.json lacks its figures" >"/dev/stderr"
        exit 1
    }
    printf "{%s, \"domain\": %s, \"sync\": \"%s\", ", head, number["domain"], number["sync"] ~ /shadow \(/ ? "shadow" : "neighbours"
    printf "\"ranks\": %d, \"threads\": %d, \"cores\": %d, \"particles\": %d, \"steps\": %d, \"rebuilds\": %d, ", number["ranks"],
        number["threads"], used, number["particles"], steps, number["rebuilds"]
    printf "\"seconds\": %.6g, \"ns_per_particle\": %.6g, ", number["seconds"], 1e9 * number["seconds"] / steps / number["particles"]
    printf "\"pupcs\": %.6g, \"setup_seconds\": %.4g, ", steps * number["particles"] / number["seconds"] / used, number["seconds_setup"]
    printf "\"imbalance\": %.4g, \"sync_share\": %.4g, ", number["imbalance"], number["sync_share"]
    printf "\"ghosts\": %.6g, \"ghosts_most\": %d, ", means["ghosts"], mosts["ghosts"]
    printf "\"messages\": %.6g, \"messages_most\": %.6g, ", means["messages"] / steps, mosts["messages"] / steps
    printf "\"bytes\": %.6g, \"bytes_most\": %.6g, ", means["bytes"] / steps, mosts["bytes"] / steps
    printf "\"rebuild_messages\": %.6g, \"rebuild_bytes\": %.6g, ", number["rebuild_messages"] / number["ranks"] / steps,
        number["rebuild_bytes"] / number["ranks"] / steps
    printf "\"memory\": %.6g, \"memory_most\": %.6g, \"memory_peak\": %.0f, ", number["memory_held"] / number["ranks"],
        number["bytes_per_particle"] * number["particles"] / number["ranks"], number["memory_peak"]
    printf "\"stages\": {%s}}\n", stages
}
