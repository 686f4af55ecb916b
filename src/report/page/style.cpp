#include "page/html.h"

namespace fusee::report {

std::string style_sheet() {
    return R"css(
:root{color-scheme:light dark;--page:#f6f6f3;--card:#fff;--line:#e2e1dc;--ink:#15151a;--soft:#5b5a57;--faint:#6f6e69;--rule:#8b8a85;--body:#e9e8e3;
--se:#2a78d6;--pe:#d95f27;--sum:#4b4a48;--t:#7a52c7;--exact:#7a52c7;--linear:#1a9a72;
--pass:#0d6b3d;--warning:#7d5300;--error:#a92524;--link:#1c5fb0;--pass-bg:#e3f4ea;--warning-bg:#fdf1cf;--error-bg:#fde4e2}
@media (prefers-color-scheme:dark){:root{--page:#131315;--card:#1c1c1f;--line:#34343a;--ink:#f3f2ee;--soft:#b7b5ae;--faint:#a3a19a;--rule:#8d8b85;
--body:#2b2b30;
--se:#5aa0f2;--pe:#f08a55;--sum:#c4c2bb;--t:#a98bf0;--exact:#a98bf0;--linear:#3fc496;
--link:#8abcf8;--pass:#5fd394;--warning:#f2c04b;--error:#ff8a80;--pass-bg:#16301f;--warning-bg:#362a0c;--error-bg:#3d1917}}
*{box-sizing:border-box}
body{margin:0;background:var(--page);color:var(--ink);font:15px/1.5 system-ui,-apple-system,"Segoe UI",Roboto,"DejaVu Sans",sans-serif}
html{scroll-behavior:smooth;scroll-padding-top:12px}@media (prefers-reduced-motion:reduce){html{scroll-behavior:auto}}
a{color:var(--link)}:focus-visible{outline:3px solid var(--se);outline-offset:2px;border-radius:4px}main:focus{outline:0}
.skip{position:absolute;left:-9999px}.skip:focus{left:12px;top:12px;background:var(--card);padding:8px 14px;z-index:9}
body>header,.columns{max-width:1440px;margin:0 auto;padding:28px 24px 0}.columns{padding:12px 24px 64px}
nav ol{display:flex;flex-wrap:wrap;gap:2px 16px;list-style:none;margin:0;padding:0;font-size:14px}
nav a{color:var(--soft);text-decoration:none;display:block;padding:3px 0}nav a:hover{text-decoration:underline}
nav a[aria-current]{color:var(--ink);font-weight:600}
@media (min-width:1180px){.columns{display:grid;grid-template-columns:200px minmax(0,1fr);gap:32px}
nav{position:sticky;top:24px;align-self:start;max-height:calc(100vh - 48px);overflow-y:auto;padding:44px 8px 0 2px}
nav ol{flex-direction:column;gap:2px}nav a{border-left:3px solid var(--line);padding:4px 0 4px 12px}
nav a[aria-current]{border-color:var(--se)}.columns:not(:has(nav)){display:block}}
h1{font-size:30px;line-height:1.2;margin:2px 0 10px;overflow-wrap:anywhere}h2{font-size:20px;margin:36px 0 12px}
.lead{font-size:18px;margin:12px 0;max-width:70ch;overflow-wrap:anywhere}
h3{font-size:16px;margin:0 0 8px}
p{margin:6px 0 12px;max-width:80ch}.eyebrow,.stamp{color:var(--soft);font-size:13px;margin:8px 0 0;overflow-wrap:anywhere}
.verdict,.tag{display:inline-block;border-radius:99px;font-weight:600}.tag{white-space:nowrap}.verdict{padding:6px 16px;border-radius:18px}
.tag{padding:1px 10px;font-size:13px}
.pass-tag{background:var(--pass-bg);color:var(--pass)}.warning-tag{background:var(--warning-bg);color:var(--warning)}
.unjudged-tag{background:var(--line);color:var(--ink)}.error-tag{background:var(--error-bg);color:var(--error)}
.tiles{display:grid;grid-template-columns:repeat(auto-fit,minmax(min(230px,100%),1fr));gap:12px;margin-top:20px}
.card,.tile{background:var(--card);border:1px solid var(--line);border-radius:12px;padding:16px 18px}
.tile b{display:block;font-size:22px;line-height:1.3;font-weight:650}.tile span{color:var(--soft);font-size:13px}
.grid{display:grid;grid-template-columns:repeat(2,minmax(0,1fr));gap:14px}.wide{grid-column:1/-1}
.part{display:grid;grid-template-columns:minmax(0,1.15fr) minmax(0,1fr);gap:14px}.part>figure{align-self:start}
.stack{display:grid;gap:14px;align-content:start}
figure{margin:0}.plot{max-width:760px;position:relative;background:var(--card);border:1px solid var(--line);border-radius:12px;padding:14px 12px 8px}
figcaption{font-weight:600;font-size:14px;padding:0 6px 2px}
svg{display:block;font-family:inherit}svg.cam,.plot svg{width:100%;height:auto}svg text{fill:var(--soft)}
.plot text{font-size:12px}.plot .name{fill:var(--ink)}.plot .key{fill:var(--ink)}.plot .note{font-size:11px;fill:var(--faint)}.plan svg>rect{fill:none}.plan path,.plan polygon,.plan line{stroke:currentColor}
.plot .rule{stroke:var(--line);fill:none}.plot .axis{stroke:var(--rule);fill:none}
.plot .shade{fill:var(--ink);opacity:.06}.plot .mark{stroke:var(--rule);stroke-dasharray:3 3;fill:none}
.curve{fill:none;stroke-width:2;stroke-linejoin:round}.dashed{stroke-dasharray:6 4}
.curve.se{stroke:var(--se)}.curve.pe{stroke:var(--pe)}.curve.sum{stroke:var(--sum)}.curve.t{stroke:var(--t)}
.curve.exact{stroke:var(--exact)}.curve.linear{stroke:var(--linear)}
.dot.se,.band.se{fill:var(--se)}.dot.pe,.band.pe{fill:var(--pe)}.dot.t,.band.t{fill:var(--t)}
.dot.exact,.band.exact{fill:var(--exact)}.dot.linear,.band.linear{fill:var(--linear)}.dot.sum,.band.sum{fill:var(--sum)}
.band{opacity:.15}.curve.bar{stroke-width:1.1}
svg.cam path,svg.cam circle{vector-effect:non-scaling-stroke}
.cam .body{fill:var(--body);fill-rule:evenodd;stroke:var(--sum);stroke-width:1.2}
.cam .boss{fill:none;stroke:var(--rule);stroke-dasharray:5 3}
.cam .floor{fill:none;stroke:var(--rule);stroke-width:1}.cam .pitch{fill:none;stroke:var(--soft);stroke-width:1;stroke-dasharray:1 3}
.cam .working{fill:none;stroke-width:3.5;stroke-linecap:round}.k_se .working{stroke:var(--se)}.k_pe .working{stroke:var(--pe)}
.cam .axis path,.cam .scale path{stroke:var(--soft);fill:none;stroke-width:1}
.cam .cable path{stroke:var(--ink);stroke-width:1.5;fill:none}
.cam .cable circle{fill:var(--ink)}.cam .end path{stroke-dasharray:5 3}.cam .cable text,.cam .scale text{fill:var(--ink)}
.place .leader{stroke-width:.8;fill:none}.place text{font-weight:700}.place.pass circle{opacity:.6}.place:focus .disc,.place:target .disc{stroke:var(--ink);stroke-width:.6}
.place.pass circle{fill:var(--pass)}.place.warning .leader{stroke:var(--warning)}.place.warning circle{fill:var(--warning)}
.place.error .leader{stroke:var(--error)}.place.error circle{fill:var(--error)}
.place.warning text,.place.error text{fill:var(--card)}
.scroll{overflow-x:auto;background:var(--card);border:1px solid var(--line);border-radius:12px}
caption{position:absolute;width:1px;height:1px;overflow:hidden;clip-path:inset(50%);white-space:nowrap}.scroll{position:relative}
table{border-collapse:collapse;width:100%;font-size:14px}tr:target td,tr:has(:target) td{background:var(--warning-bg)}
details{border-top:1px solid var(--line);margin-top:14px}details>summary{cursor:pointer;padding:10px 0;color:var(--link)}
section>details>summary h2{display:inline;margin:0;color:var(--ink)}summary span{color:var(--soft);font-size:13px;margin-left:12px}
details.block{border:0;margin-top:8px}details[open]>summary{margin-bottom:6px}
th,thead td{color:var(--soft);font-weight:600;text-align:left;font-size:13px;white-space:nowrap}
th,td{padding:9px 12px;border-bottom:1px solid var(--line);vertical-align:top}tbody tr:last-child td{border-bottom:0}
.num{font-variant-numeric:tabular-nums;white-space:nowrap}
.code{font-family:ui-monospace,Menlo,Consolas,"DejaVu Sans Mono",monospace;font-size:12.5px}
.held{margin:20px 0 8px}.dense table{font-size:13px}.dense td{padding:5px 12px}.dense br{display:none}
.dense span.faint::before{content:" \00b7\00a0"}.dense .faint{font-size:12px}
.faint{color:var(--soft);font-size:13px}.fix{font-weight:600}
dl{display:grid;grid-template-columns:max-content 1fr;gap:5px 16px;margin:0;font-size:14px}dt{color:var(--soft)}
dd{margin:0;text-align:right;font-variant-numeric:tabular-nums}
.wide dl{grid-template-columns:repeat(2,max-content 1fr)}.wide dd{text-align:left}
.matrix{max-width:none;border:0}.schema{max-width:520px}.schema .thing{fill:var(--body);stroke:var(--rule)}.schema .line{stroke:var(--rule);fill:none;stroke-width:2}
.schema .faulty .thing{fill:var(--error-bg);stroke:var(--error);stroke-width:3}.schema .faulty .line{stroke:var(--error);stroke-width:4}
.schema .possible .thing{fill:var(--warning-bg);stroke:var(--warning);stroke-width:2;stroke-dasharray:5 3}
.schema .possible .line{stroke:var(--warning);stroke-width:4;stroke-dasharray:5 3}.schema text{fill:var(--ink)}
.schema .faulty text{fill:var(--error);font-weight:700}.schema .possible text{fill:var(--warning);font-weight:700}
@media (max-width:640px){.cards{background:none;border:0}.cards thead{display:none}.cards table,.cards tbody,.cards tr,.cards td{display:block}
.cards tr{background:var(--card);border:1px solid var(--line);border-radius:12px;padding:10px 14px;margin-bottom:10px}
.cards td{border:0;padding:2px 0;white-space:normal;overflow-wrap:anywhere}
.cards td[data-label]::before{content:attr(data-label) ": ";color:var(--soft);font-size:12.5px}
.cards td[data-label=rule]::before,.cards td[data-label=finding]::before{content:""}
.tile b{font-size:18px}.tile{padding:10px 14px}h1{font-size:25px}.lead{font-size:16px}dl{overflow-wrap:anywhere}
dl,.wide dl{grid-template-columns:minmax(90px,max-content) minmax(0,1fr)}}
@media (max-width:820px){.wide dl{grid-template-columns:max-content 1fr}.grid,.part{grid-template-columns:minmax(0,1fr)}
body>header,.columns{padding-left:14px;padding-right:14px}}
@page{margin:12mm}
@media print{:root{--page:#fff}body{font-size:11px}body>header,.columns{max-width:none;padding:0;display:block}nav,.skip,button{display:none}
details::details-content{content-visibility:visible;block-size:auto;opacity:1}summary{list-style:none}
@supports not selector(::details-content){details:not([open])>summary::after{content:" (folded: open it on the screen to print it)"}}
h1{font-size:22px}
h2{font-size:15px;margin:18px 0 8px;break-after:avoid}
dl,table,.dense table{font-size:10px}th,.faint,.dense .faint,.code,.tag{font-size:9.5px}th,td,.dense td{padding:3px 7px}
.tile b{font-size:15px}
.tiles{grid-template-columns:repeat(4,1fr)}figcaption,h3{font-size:11px;break-after:avoid}.grid{grid-template-columns:1fr 1fr}
.part{grid-template-columns:1.2fr 1fr}.wide dl{grid-template-columns:repeat(2,max-content 1fr)}
.card,.plot,.tile,tr,svg{break-inside:avoid}.scroll{overflow:visible}}
)css";
}

}  // namespace fusee::report
