#include "page/html_parts.hpp"

namespace cgw::page {

// Colours keep a contrast of 4.5 and more to what is behind them, in both schemes; tests/judges/report holds
// them to it.
const std::string_view style_sheet = R"css(:root { color-scheme: light dark; --ink: #1a1f24; --paper: #ffffff;
  --soft: #f2f4f6; --line: #b9c1c9; --quiet: #4d5863; --good: #146c2e; --warning: #7a4a00; --bad: #b3121d;
  --part: #d6e6f5; --part-edge: #33618c; --link: #0b57a4 }
@media (prefers-color-scheme: dark) { :root { --ink: #e6e9ec; --paper: #14181c; --soft: #20262c; --line: #4b555f;
  --quiet: #b0bac4; --good: #6fd08c; --warning: #f0b64d; --bad: #ff8f8a; --part: #1f3a54; --part-edge: #7fb2e0;
  --link: #8cc0f5 } }
* { box-sizing: border-box }
html { -webkit-text-size-adjust: 100% }
body { margin: 0 auto; padding: 1rem; max-width: 64rem; font: 1rem/1.45 system-ui, sans-serif; color: var(--ink);
  background: var(--paper); overflow-wrap: break-word }
h1 { font-size: 1.6rem; line-height: 1.2; margin: 0 0 .3rem }
h2 { font-size: 1.25rem; margin: 2.2rem 0 .6rem; padding-top: .4rem; border-top: 2px solid var(--line) }
h3 { font-size: 1.05rem; margin: 1.4rem 0 .4rem }
h4 { font-size: 1rem; margin: 1rem 0 .3rem }
p { margin: .4rem 0 }
a { color: var(--link) }
.subtitle { color: var(--quiet) }
nav ul { list-style: none; padding: 0; display: flex; flex-wrap: wrap; gap: .2rem 1.2rem }
nav a { display: inline-block; padding: .2rem 0 }
.verdict { border-left: .5rem solid; padding: .6rem 1rem; margin: 1rem 0; background: var(--soft) }
.verdict strong { font-size: 1.25rem }
.verdict ul { margin: .4rem 0 0; padding-left: 1.2rem; color: var(--ink) }
.good { color: var(--good) }
.warning { color: var(--warning) }
.bad { color: var(--bad) }
.mark { font-weight: 700 }
.wide { overflow-x: auto; margin: .6rem 0 }
.wide:focus { outline: 2px solid var(--link) }
table { border-collapse: collapse; font-size: .92rem; min-width: 50% }
caption { text-align: left; color: var(--quiet); padding-bottom: .3rem }
th, td { border: 1px solid var(--line); padding: .25rem .5rem; text-align: left; vertical-align: top }
thead th { background: var(--soft) }
tbody th { font-weight: 400 }
.number { text-align: right; font-variant-numeric: tabular-nums; white-space: nowrap }
.box { min-width: 3.5rem }
figure { margin: .6rem 0 }
figcaption { color: var(--quiet); font-size: .92rem }
svg { display: block; max-width: 100%; height: auto }
svg.bar { width: 6rem; height: .7rem; margin: .2rem 0 0 }
.number svg.bar { margin-left: auto }
svg text { font: 13px system-ui, sans-serif; fill: var(--ink) }
svg text.small { font-size: 11px; fill: var(--quiet) }
.part { fill: var(--part); stroke: var(--part-edge) }
.gap { fill: none; stroke: var(--line); stroke-dasharray: 3 3 }
.track { fill: var(--soft); stroke: var(--line) }
svg .good { fill: var(--good) }
svg .warning { fill: var(--warning) }
svg .bad { fill: var(--bad) }
svg .plain { fill: var(--part-edge) }
@media (max-width: 32rem) { body { padding: .6rem } h1 { font-size: 1.35rem } }
@page { size: A4; margin: 14mm }
@media print { :root { color-scheme: light; --ink: #000; --paper: #fff; --soft: #f2f4f6; --line: #888; --quiet: #333;
  --good: #146c2e; --warning: #7a4a00; --bad: #b3121d; --part: #e4eef8; --part-edge: #33618c; --link: #000 }
  body { font-size: 9.5pt; max-width: none; padding: 0 } nav { display: none } .wide { overflow: visible }
  table { font-size: 8.5pt } thead { display: table-header-group } tr, figure, .verdict { break-inside: avoid }
  h2, h3, h4 { break-after: avoid } }
)css";

}  // namespace cgw::page
