# CTest's JUnit file -> output of what failed, reasons of what was skipped, one line of totals; status 1 on failures.
# A test that ran none of Catch's cases has failed: its name was taken for a filter that matches nothing.
function decoded(text) {
  gsub(/&lt;/, "<", text); gsub(/&gt;/, ">", text); gsub(/&quot;/, "\"", text); gsub(/&apos;/, "\047", text)
  gsub(/&amp;/, "\\&", text)
  return text
}
function attribute(key) {
  return match($0, " " key "=\"[^\"]*\"") ? substr($0, RSTART + length(key) + 3, RLENGTH - length(key) - 4) : ""
}
/<testcase / { name = decoded(attribute("name")); state = attribute("status"); output = ""; skip = ""; reason = "" }
/<skipped / { skip = attribute("message") }
/<system-out>/ { inside = 1; sub(/.*<system-out>/, "") }
inside {
  text = $0; ends = sub(/<\/system-out>.*/, "", text); text = decoded(text)
  output = output text "\n"
  if (text ~ /^skipped: / && reason == "") reason = substr(text, 10)
  if (text ~ /^No tests ran/) state = "fail"
  if (ends) inside = 0
}
/<\/testcase>/ {
  if (state == "run") passed++
  else if (skip ~ /^SKIP_RETURN_CODE/) {
    skipped++
    if (reason == "") reason = "no reason given"
    if (!(reason in count)) order[++reasons] = reason
    count[reason]++
  } else { failed++; print "---- failed: " name (skip == "" ? "" : " (" skip ")"); printf "%s", output }
}
END {
  for (i = 1; i <= reasons; i++) print "skipped " count[order[i]] ", because: " order[i]
  printf "%d passed, %d failed, %d skipped\n", passed, failed, skipped
  exit failed > 0
}
