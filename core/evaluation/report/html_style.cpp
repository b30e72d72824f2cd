#include "core/evaluation/report/html_style.hpp"

namespace abrazo {

const char* const html_style_sheet = R"css(
:root { color-scheme: light dark; --page:#fdfdfb; --ink:#1d1f21; --muted:#62676d; --grid:#dddcd6; --line:#bdbcb5;
  --soft:#f4f3ee; --accent:#0072b2; --reference:#74787d; --series-1:#0072b2; --series-2:#d55e00; --series-3:#009e73;
  --series-4:#b8638f; --series-5:#c98a00; --series-6:#3c9fd4; --series-7:#9c9100; }
@media (prefers-color-scheme: dark) { :root { --page:#16181a; --ink:#e4e3de; --muted:#a0a4a8; --grid:#33373b; --line:#50555a;
  --soft:#1e2124; --accent:#6cb8e8; --reference:#8d9297; --series-1:#56b4e9; --series-2:#ee7f35; --series-3:#2fbf95;
  --series-4:#d98bb4; --series-5:#e6a823; --series-6:#9ad4f5; --series-7:#e8de4f; } }
* { box-sizing: border-box; }
html { -webkit-text-size-adjust: 100%; }
body { margin: 0; background: var(--page); color: var(--ink);
  font: 17px/1.55 Charter, "Bitstream Charter", "Iowan Old Style", Cambria, Georgia, serif; }
main { max-width: 1060px; margin: 0 auto; padding: 44px 24px 72px; }
h1 { font-size: 2rem; line-height: 1.2; margin: 0 0 .3rem; font-weight: 600; letter-spacing: -.01em; }
h2 { font-size: 1.32rem; line-height: 1.3; margin: 3.4rem 0 .7rem; padding-top: 1.1rem; border-top: 1px solid var(--line); font-weight: 600; }
h3 { font-size: 1rem; margin: 1.8rem 0 .3rem; font-weight: 600; }
p { margin: .5rem 0; max-width: 44rem; }
.subtitle { color: var(--muted); font-size: 1.08rem; margin: 0 0 1.4rem; }
nav { margin: 1.6rem 0 0; font-size: .95rem; line-height: 1.9; }
nav a { color: var(--accent); text-decoration: none; margin-right: 1.4em; white-space: nowrap; }
nav a:hover { text-decoration: underline; }
dl.facts { display: grid; grid-template-columns: max-content 1fr; gap: .25rem 1.4rem; margin: 1rem 0; font-size: .97rem; }
dl.facts dt { color: var(--muted); }
dl.facts dd { margin: 0; overflow-wrap: anywhere; }
.tiles { display: grid; grid-template-columns: repeat(auto-fit, minmax(172px, 1fr)); gap: 1px; margin: 1.8rem 0; padding: 1px; }
.tile { outline: 1px solid var(--grid); padding: .85rem 1rem .9rem; }
.tile .name { color: var(--muted); font-size: .86rem; line-height: 1.3; }
.tile .value { font-size: 1.6rem; line-height: 1.35; font-variant-numeric: lining-nums tabular-nums; }
.tile .comparison { font-size: .86rem; line-height: 1.35; color: var(--muted); }
.finding { font-size: 1.06rem; }
.table { overflow-x: auto; margin: 0 0 1.3rem; }
table { border-collapse: collapse; font-size: .93rem; line-height: 1.35; font-variant-numeric: lining-nums tabular-nums; }
p.caption { margin: 1.3rem 0 .5rem; max-width: none; color: var(--muted); font-size: .93rem; line-height: 1.4; }
thead th { border-top: 1.5px solid var(--ink); border-bottom: 1px solid var(--ink); font-weight: 600; vertical-align: bottom; max-width: 9.5rem; }
tbody tr:last-child > * { border-bottom: 1.5px solid var(--ink); }
th, td { padding: .3rem .8rem; text-align: right; }
th:first-child, td:first-child { text-align: left; padding-left: .2rem; }
table.words td { text-align: left; }
table.words thead th { text-align: left; }
tbody th { font-weight: 400; min-width: 3.5rem; }
.long-names tbody th { min-width: 9rem; }
td { white-space: nowrap; }
tr.paper > * { background: var(--soft); font-style: italic; }
tr.baseline > * { color: var(--muted); }
.figures { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(100%, 440px), 1fr)); gap: 1.6rem 2rem; margin: 1.6rem 0; align-items: start; }
.side-by-side { display: flex; flex-wrap: wrap; gap: 0 2rem; align-items: flex-start; }
.side-by-side table { font-size: .88rem; }
.side-by-side th, .side-by-side td { padding: .28rem .45rem; }
.side-by-side th:first-child { padding-left: .2rem; }
.side-by-side > * { flex: 0 1 auto; max-width: 100%; }
.side-by-side > * > .figures { grid-template-columns: minmax(0, 480px); }
.side-by-side > * > .notes { max-width: 29rem; }
figure { margin: 0; overflow-x: auto; }
svg.plot { display: block; max-width: 100%; height: auto; font-family: system-ui, "Helvetica Neue", Arial, "Liberation Sans", sans-serif; }
.notes { margin: 1.3rem 0; }
.notes ul { margin: .3rem 0; padding-left: 1.15rem; max-width: 44rem; }
.notes li { margin: .35rem 0; }
.definitions { margin: 1.3rem 0; padding-left: 1rem; border-left: 2px solid var(--grid); font-size: .92rem; line-height: 1.5; color: var(--muted); }
.definitions p { max-width: 47rem; }
sub { line-height: 0; font-size: .72em; }
code { font: .87em ui-monospace, "DejaVu Sans Mono", Menlo, monospace; overflow-wrap: anywhere; }
footer { margin-top: 3rem; color: var(--muted); font-size: .88rem; }
@media (max-width: 620px) { body { font-size: 16px; } main { padding: 26px 16px 48px; } h1 { font-size: 1.6rem; }
  .tiles { grid-template-columns: 1fr 1fr; } .tile { padding: .7rem .75rem; } .tile .value { font-size: 1.3rem; }
  dl.facts { grid-template-columns: 1fr; gap: 0; } dl.facts dd { margin-bottom: .45rem; } th, td { padding: .28rem .5rem; } }
@media print { :root { --page:#fff; --ink:#000; --muted:#444; --grid:#ccc; --line:#888; --soft:#f2f2f2; --accent:#000; --reference:#666;
    --series-1:#0072b2; --series-2:#d55e00; --series-3:#009e73; --series-4:#b8638f; --series-5:#c98a00; --series-6:#3c9fd4; --series-7:#9c9100; }
  body { font-size: 10.5pt; } main { max-width: none; padding: 0; } nav { display: none; }
  .figures { grid-template-columns: 1fr 1fr; } .table { overflow: visible; }
  figure, tr, .tile { break-inside: avoid; } h2, h3 { break-after: avoid; }
  * { -webkit-print-color-adjust: exact; print-color-adjust: exact; } }
)css";

}  // namespace abrazo
