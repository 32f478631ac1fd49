"""The report's style sheet."""

STYLE = """
:root {
  --paper: #ffffff; --ink: #1b1f24; --muted: #6b7280; --line: #d7dbe0; --fill: #e4e8ee;
  --ours: #1660c9; --theirs: #d9600d; --good: #14733a; --bad: #b3201b; --soft: #f4f6f8; --bar: #bcd5f7;
}
@media (prefers-color-scheme: dark) {
  :root {
    --paper: #14171c; --ink: #e7eaee; --muted: #98a1ad; --line: #343b45; --fill: #2c333d;
    --ours: #6cb0ff; --theirs: #ff9d5c; --good: #63d18c; --bad: #ff8a80; --soft: #1d2229; --bar: #24456e;
  }
}
* { box-sizing: border-box; }
body { margin: 0; background: var(--paper); color: var(--ink); font: 16px/1.5 system-ui, sans-serif; }
main { max-width: 62rem; margin: 0 auto; padding: 1rem; }
h1 { font-size: 1.5rem; line-height: 1.25; }
h2 { font-size: 1.15rem; margin-top: 2.2rem; border-bottom: 1px solid var(--line); padding-bottom: .2rem; }
.verdict { font-size: 1.15rem; font-weight: 600; padding: .7rem .9rem; background: var(--soft); border-left: .4rem solid; }
.good { color: var(--good); }
.bad, tr.bad th, tr.bad td { color: var(--bad); font-weight: 600; }
.note { color: var(--muted); font-size: .9rem; }
.wide { overflow-x: auto; }
table { border-collapse: collapse; font-size: .9rem; }
th, td { padding: .25rem .6rem; text-align: right; font-variant-numeric: tabular-nums; vertical-align: top; }
th:first-child, td.word, thead th:last-child { text-align: left; }
tbody th { font-weight: 400; }
thead th { border-bottom: 1px solid var(--muted); }
tr.group th { text-align: left; font-weight: 600; padding-top: .8rem; border-bottom: 1px solid var(--line); }
.numbers td, .numbers th { white-space: nowrap; }
.numbers th:first-child { position: sticky; left: 0; background: var(--paper); }
.chart { width: 100%; table-layout: fixed; }
.chart th:first-child { width: 30%; }
.chart td { background: linear-gradient(to right, var(--bar) var(--share), transparent var(--share)) no-repeat; }
thead th.word { text-align: left; }
.chart thead th:last-child, .mistakes thead th:last-child { text-align: right; }
.mistakes th b { display: block; }
.mistakes tbody tr { border-bottom: 1px solid var(--line); break-inside: avoid; }
dl { display: grid; grid-template-columns: auto 1fr; gap: .15rem .8rem; font-size: .9rem; }
dt { font-weight: 600; }
dd { margin: 0; }
.grid { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(100%, 24rem), 1fr)); gap: 1rem; }
figure { margin: 0; padding: .8rem; background: var(--soft); border-radius: .4rem; break-inside: avoid; min-width: 0; }
.narrow { max-width: 36rem; }
.ours { color: var(--ours); }
.theirs { color: var(--theirs); }
figcaption { font-size: .9rem; margin-bottom: .4rem; }
figure svg { display: block; width: 100%; height: auto; }
code { font: .78rem/1.4 ui-monospace, monospace; overflow-wrap: anywhere; }
li { margin-bottom: .4rem; }
@media (max-width: 40rem) {
  main { padding: .8rem; }
  table { font-size: .8rem; }
  th, td { padding: .2rem .4rem; }
  .numbers { font-size: .66rem; }
  .numbers th, .numbers td { padding: .15rem .15rem; }
  .numbers thead th:nth-child(4), .numbers td:nth-child(4) { display: none; }
  .chart th:first-child { width: 27%; }
  .chart th, .chart td { padding: .15rem .2rem; font-size: .75rem; }
  .mistakes thead { display: none; }
  .mistakes tr, .mistakes th, .mistakes td { display: block; text-align: left; padding: .1rem 0; }
  .mistakes tr { padding: .4rem 0; }
  .mistakes td::before { content: attr(data-label) ": "; color: var(--muted); }
}
@media print {
  :root {
    --paper: #ffffff; --ink: #000000; --muted: #555555; --line: #bbbbbb; --fill: #e4e8ee;
    --ours: #1660c9; --theirs: #d9600d; --good: #14733a; --bad: #b3201b; --soft: #ffffff; --bar: #cfe0f8;
  }
  * { print-color-adjust: exact; }
  body { font-size: 10pt; }
  main { max-width: none; padding: 0; }
  figure { border: 1px solid var(--line); }
  h2 { break-after: avoid; }
  .grid { grid-template-columns: 1fr 1fr; gap: .5rem; }
  .numbers tbody, .chart tbody { break-inside: avoid; }
  .narrow { max-width: 24rem; }
}
"""
