# awk -v version=V -f packaging/manual.awk docs/cli.md: the manual as a man page. Of Markdown it knows
# what docs/cli.md uses: sections, paragraphs, tables, blocks of code, code, bold and links. Sections
# on programs of their own (terrview-...) are left out.

function escaped(text) {
  gsub(/\\/, "\\e", text)
  gsub(/-/, "\\-", text)
  return text
}

function linkless(text,    shown) {
  while (match(text, /\[[^][]*\]\([^()]*\)/)) {
    shown = substr(text, RSTART + 1, RLENGTH - 2)
    sub(/\]\(.*/, "", shown)
    text = substr(text, 1, RSTART - 1) shown substr(text, RSTART + RLENGTH)
  }
  return text
}

# What an entry of a table explains: options bold, what stands for their values italic.
function term(text,    words, count, i, result) {
  gsub(/`/, "", text)
  gsub(BAR, "|", text)
  count = split(text, words, " ")
  for (i = 1; i <= count; ++i)
    result = result (i > 1 ? " " : "") (words[i] ~ /^-/ ? "\\fB" : "\\fI") escaped(words[i]) "\\fR"
  return result
}

function prose(text,    parts, count, i, bold, result) {
  gsub(BAR, "|", text)
  count = split(linkless(text), parts, "`")
  for (i = 1; i <= count; ++i) {
    if (i % 2 == 0) {
      result = result "\\fB" escaped(parts[i]) "\\fR"
      continue
    }
    gsub(/\\/, "\\e", parts[i])
    while (sub(/\*\*/, bold ? "\\fR" : "\\fB", parts[i])) bold = !bold
    result = result parts[i]
  }
  sub(/^[.']/, "\\\\\\&&", result)
  return result
}

function end_paragraph() {
  if (paragraph != "") printf ".PP\n%s\n", prose(paragraph)
  paragraph = ""
}

function heading(text) {
  if (text != "option") print ".SS \"" toupper(substr(text, 1, 1)) substr(text, 2) "\""
}

function entry(what, meaning, default_value) {
  if (default_value != "" && meaning != "" && meaning !~ /[.:]$/) meaning = meaning "."
  if (default_value != "") meaning = meaning " Default: " default_value "."
  sub(/^ /, "", meaning)
  printf ".TP\n%s\n%s\n", term(what), prose(meaning)
}

function row(    cells, count, i) {
  gsub(/\\\|/, BAR)
  count = split($0, cells, "|")
  for (i = 2; i < count; ++i) gsub(/^ +| +$/, "", cells[i])
  if (!in_table) heading(cells[2])
  else if (cells[2] !~ /^-+$/) entry(cells[2], cells[3], count > 4 ? cells[4] : "")
  in_table = 1
}

BEGIN { BAR = "\001" }

/^(#|```|\||$)/ { end_paragraph() }
!/^\|/ { in_table = 0 }

/^# / {
  printf ".TH TERRVIEW 1 \"\" \"terrview %s\" \"User Commands\"\n.ad l\n", version
  print ".SH NAME\nterrview \\- what can be seen of a landscape from a point on the Earth\n.SH SYNOPSIS"
  next
}

/^## / {
  left_out = /^## terrview-/
  if (!left_out) print ".SH " toupper(substr($0, 4))
  next
}

left_out { next }

/^```/ {
  in_code = !in_code
  print in_code ? ".nf" : ".fi"
  if (!in_code && !described++) print ".SH DESCRIPTION"
  next
}

in_code { print escaped($0) }
/^\|/ { row() }
!in_code && !/^(\||$)/ { paragraph = paragraph (paragraph == "" ? "" : " ") $0 }

END {
  end_paragraph()
  print ".SH SEE ALSO\nThe pages named here (frames.md and others) and a sample landscape are in the folder"
  print ".I ../share/doc/terrview\nbeside the program's."
}
