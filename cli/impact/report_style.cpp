#include "cli/impact/report_style.h"

namespace terrview {

const std::string_view kReportStyle = R"css(
:root { --ink: #1f2429; --soft: #5b656e; --line: #d5dadf; --wash: #f4f6f7; --accent: #b3500f; }
* { box-sizing: border-box; }
body {
  margin: 0 auto; padding: 3rem 1.5rem 4rem; max-width: 66rem; color: var(--ink);
  background: #fff; font: 1rem/1.5 "Source Sans 3", "Segoe UI", "Helvetica Neue", Arial, sans-serif;
}
header { border-bottom: 3px solid var(--ink); padding-bottom: 1.2rem; margin-bottom: 2rem; }
.kind { margin: 0; color: var(--accent); font-weight: 600; letter-spacing: 0.06em;
  text-transform: uppercase; font-size: 0.8rem; }
h1 { font-size: 2.1rem; line-height: 1.15; margin: 0.2rem 0 0.6rem; overflow-wrap: anywhere; }
h2 { font-size: 1.45rem; line-height: 1.25; margin: 2.6rem 0 0.8rem; overflow-wrap: anywhere; }
h2 .number { display: inline-block; min-width: 1.7em; margin-right: 0.5em; padding: 0 0.35em;
  border-radius: 0.9em; background: var(--ink); color: #fff; text-align: center; font-size: 0.8em; }
h2 .number.blind { background: #fff; color: var(--ink); outline: 2px solid var(--ink); }
h3 { font-size: 1.05rem; margin: 1.6rem 0 0.4rem; }
p, dl, ul { margin: 0.5rem 0; max-width: 46rem; }
.lead { font-size: 1.15rem; }
.meta, figcaption, .note { color: var(--soft); font-size: 0.9rem; }
a { color: inherit; }
figure { margin: 1rem 0; }
img { display: block; width: 100%; height: auto; background: var(--wash); }
table { border-collapse: collapse; min-width: 60%; margin: 0.6rem 0 1rem; font-size: 0.92rem;
  font-variant-numeric: tabular-nums; }
caption { text-align: left; color: var(--soft); font-size: 0.9rem; padding-bottom: 0.3rem; }
th { text-align: left; font-weight: 600; vertical-align: bottom; border-bottom: 1.5px solid var(--ink); }
th, td { padding: 0.3rem 0.6rem 0.3rem 0; }
td { border-bottom: 1px solid var(--line); vertical-align: top; }
th.n, td.n { text-align: right; white-space: nowrap; }
th.n:not(:last-child), td.n:not(:last-child) { padding-right: 1.1rem; }
th.n { white-space: normal; }
tr.total td { font-weight: 600; }
td.name { overflow-wrap: anywhere; }
.wide { overflow-x: auto; }
.pairs { display: grid; grid-template-columns: max-content 1fr; gap: 0.15rem 1.2rem; max-width: none;
  font-size: 0.92rem; }
.pairs dt { color: var(--soft); }
.pairs dd { margin: 0; overflow-wrap: anywhere; }
pre { background: var(--wash); padding: 0.6rem 0.8rem; margin: 0.4rem 0 0.8rem; font-size: 0.78rem;
  line-height: 1.4; white-space: pre-wrap; overflow-wrap: anywhere;
  font-family: "DejaVu Sans Mono", Consolas, monospace; }
details > summary { cursor: pointer; font-size: 0.92rem; }

.map { display: block; width: 100%; height: auto; border: 1px solid var(--line); }
.map text { font: 600 16px Arial, sans-serif; text-anchor: middle; fill: var(--ink); }
.map .sight { stroke: var(--ink); stroke-width: 1.2; stroke-dasharray: 2 5; }
.map .seeing circle { fill: var(--ink); stroke: #fff; stroke-width: 2; }
.map .seeing text { fill: #fff; }
.map .blind circle { fill: #fff; stroke: var(--ink); stroke-width: 2; }
.map .project { fill: var(--accent); }
.map .project-mark { fill: var(--accent); stroke: #fff; stroke-width: 2; }
.map .scale path { fill: none; stroke: var(--ink); stroke-width: 2; }
.map .scale rect, .map .north circle { fill: #fff; fill-opacity: 0.8; }
.map .north path { fill: var(--ink); }
.key { display: inline-block; width: 0.9em; height: 0.9em; margin: 0 0.35em 0 0.9em;
  vertical-align: -0.08em; border-radius: 50%; border: 2px solid var(--ink); background: #fff; }
.key.seeing { background: var(--ink); }
.key.zone { border: 0; border-radius: 0; background: #dda48c; }
.key.project { border: 0; border-radius: 0; background: var(--accent);
  clip-path: polygon(50% 0, 100% 100%, 0 100%); }

.frame { position: relative; --at: 50%; }
.frame .side { margin: 0; }
.frame .after { position: absolute; inset: 0; clip-path: inset(0 0 0 var(--at)); }
.frame figcaption { position: absolute; top: 0.6rem; padding: 0.1rem 0.6rem; color: #fff;
  background: rgb(20 24 28 / 72%); font-weight: 600; }
.frame .before figcaption { left: 0.6rem; }
.frame .after figcaption { right: 0.6rem; }
.frame .split { position: absolute; top: 0; bottom: 0; left: var(--at); width: 2px;
  margin-left: -1px; background: #fff; box-shadow: 0 0 3px rgb(0 0 0 / 60%); }
.slide { display: flex; align-items: center; gap: 0.8rem; font-size: 0.9rem; color: var(--soft); }
.slide input { flex: 1; accent-color: var(--accent); min-width: 8rem; height: 1.8rem; margin: 0; }
.two { display: grid; grid-template-columns: 1fr 1fr; gap: 1rem; }
.two figure { margin: 0.6rem 0; }
.two img { border: 1px solid var(--line); }

@media (max-width: 40rem) { .two, .pairs { grid-template-columns: 1fr; } .pairs dd { margin-bottom: 0.4rem; } }

@page { size: A4; margin: 16mm 15mm 18mm; }
@media print {
  html { font-size: 9.5pt; }
  body { padding: 0; max-width: none; }
  h2 { margin-top: 0; }
  h2, h3 { break-after: avoid; }
  section { break-before: page; }
  section.follows { break-before: auto; margin-top: 8mm; }
  figure, table, pre, .pairs { break-inside: avoid; }
  .map { max-height: 170mm; width: auto; max-width: 100%; margin: 0 auto; }
  .frame { display: grid; grid-template-columns: 1fr 1fr; gap: 4mm; }
  .frame .after { position: static; clip-path: none; }
  .frame figcaption { position: static; color: var(--ink); background: none; padding: 1mm 0; }
  .frame .side { display: flex; flex-direction: column; }
  .frame .split, .slide, details { display: none; }
  img, .map, .number, .key, pre { print-color-adjust: exact; -webkit-print-color-adjust: exact; }
  pre { font-size: 7pt; }
  .two { gap: 4mm; }
}
)css";

const std::string_view kReportScript = R"js(
for (const compare of document.querySelectorAll('.compare')) {
  const frame = compare.querySelector('.frame');
  const range = compare.querySelector('input');
  const show = () => {
    frame.style.setProperty('--at', range.value + '%');
    range.setAttribute('aria-valuetext', range.value + ' % of the width shows the view before');
  };
  range.addEventListener('input', show);
  show();
}
)js";

}  // namespace terrview
