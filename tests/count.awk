# Adds up JUnit files, as ctest, Vitest and Playwright write them: "passed failed skipped". A doctest program counts as its
# cases; a test that could not run has failed.
function flush() {
  if (status == "") return
  if (status == "fail" || status == "notrun") f = f ? f : 1
  else if (status == "disabled" || skips) { p = 0; s = s ? s : 1 }
  else if (!cases) p = 1
  passed += p; failed += f; skipped += s
}
/^[ \t]*<testcase / {
  flush()
  p = f = s = cases = skips = 0
  status = match($0, / status="[a-z]+"/) ? substr($0, RSTART + 9, RLENGTH - 10) : "run"
}
/^[ \t]*<(failure|error)/ { status = "fail" }
/^[ \t]*<skipped/ { skips = 1 }
/^\[doctest\] test cases:/ { gsub(/[^0-9]+/, " "); split($0, n, " "); cases = 1; p = n[2]; f = n[3]; s = n[4] }
END { flush(); print passed + 0, failed + 0, skipped + 0 }
