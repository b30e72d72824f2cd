# Turns what a program answers to --help into a part of a manual page.
#   -v title=WORDS   of a command: a heading, what it does, its usage; settings are left to their own section
#   -v only=GROUP    the entries of one group

function escaped(text) {
  gsub(/\\/, "\\e", text)
  gsub(/-/, "\\-", text)
  if (text ~ /^[.']/) text = "\\&" text
  return text
}

# An entry's name begins at the third column, its text two spaces after the name or below from the 31st on.
function print_entry(line,   gap) {
  gap = match(line, /   */)
  print ".TP"
  print ".B " escaped(gap ? substr(line, 1, gap - 1) : line)
  lines = 0
  if (gap) print_text(substr(line, gap + RLENGTH))
}

function print_text(text) {
  if (lines++ > 0) print ".br"
  print escaped(text)
}

function begin_group(name) {
  group = name
  shown = only == "" ? name != "Subcommands" : name == only
  if (title != "" && name == "Settings") {
    print ".PP\nAlso takes the settings of the section SETTINGS."
    shown = 0
  }
  if (shown && name !~ /^(Options|Positionals)$/ && only == "") print ".PP\n" escaped(name) ":"
}

NF == 0 { next }
summary == "" {
  summary = $0
  if (title != "") print ".SS " escaped(title) "\n" escaped(toupper(substr(summary, 1, 1)) substr(summary, 2)) "."
  next
}
/^Usage: / { if (title != "") print ".PP\n.B " escaped(substr($0, 8)); next }
/^[^ ].*:$/ { begin_group(substr($0, 1, length($0) - 1)); next }
!shown { next }
/^  -h,--help / && title != "" { hidden = 1; next }
/^  [^ ]/ { hidden = 0; print_entry(substr($0, 3)); next }
!hidden && /^                              / { print_text(substr($0, 31)) }
