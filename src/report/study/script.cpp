#include "study/script.h"

namespace fusee::report {

std::string_view study_style() {
    return R"css(
.columns{max-width:none}.controls{display:flex;flex-wrap:wrap;gap:10px 18px;align-items:end;margin:12px 0}
.controls label{display:grid;font-size:13px;color:var(--soft);gap:3px}
select,input{font:inherit;color:var(--ink);background:var(--card);border:1px solid var(--line);border-radius:8px;padding:5px 8px}
#filter{width:min(560px,90vw)}#message{color:var(--error);font-size:13px}
#plot{max-width:900px}#plot circle{fill:var(--se);opacity:.55;cursor:pointer}#plot circle.front{fill:var(--pe);opacity:1}
#plot circle.picked{stroke:var(--ink);stroke-width:2}
table.study{font-size:13px;white-space:nowrap}.study th{vertical-align:bottom}
.study th button{font:inherit;color:inherit;background:none;border:0;padding:0;cursor:pointer}
.study th,.study td{padding:4px 10px;border-bottom:1px solid var(--line)}.study td.num{text-align:right;font-variant-numeric:tabular-nums}
.study tr.picked td{background:var(--warning-bg)}.study svg{width:34px;height:34px;fill:var(--body);stroke:var(--sum)}
)css";
}

std::string_view study_body() {
    return R"html(
<section id="two-figures"><h2>Two figures</h2>
<div class="controls"><label>x<select id="x"></select></label><label>better<select id="bx"><option>least</option><option>greatest</option></select></label>
<label>y<select id="y"></select></label><label>better<select id="by"><option>least</option><option>greatest</option></select></label>
<label><span>Pareto front</span><input type="checkbox" id="front" checked></label></div>
<figure class="plot" id="plot"></figure><p>A click on a point opens its design's report. A design without a report moves to the top of the table.</p></section>
<section id="designs"><h2>Designs</h2>
<div class="controls"><label>Filter: a word, or a condition such as <code>mass_g &lt; 20 &amp;&amp; outcome == "made"</code>
<input id="filter" spellcheck="false"></label><span id="message" role="alert"></span><span id="count" aria-live="polite"></span></div>
<div class="scroll" role="group" aria-label="Designs" tabindex="0"><table class="study"><caption>Designs and their figures</caption><thead></thead><tbody></tbody></table></div><p><button id="more">More rows</button></p></section>
)html";
}

std::string_view study_script() {
    return R"js(
const $=id=>document.getElementById(id),C=data.columns,at=name=>C.findIndex(c=>c.name===name);
const state={sort:-1,down:false,rows:data.rows,shown:100,picked:null};
const text=v=>v===null?"\u2013":typeof v==="number"?String(Number(v.toPrecision(5))):v;
const element=(tag,attributes={},content)=>{const e=tag==="svg"||["path","circle","line","text","g"].includes(tag)||attributes.tabindex===-1?
  document.createElementNS("http://www.w3.org/2000/svg",tag):document.createElement(tag);
  for(const [k,v] of Object.entries(attributes))e.setAttribute(k,v);if(content!==undefined)e.textContent=content;return e};
/* A condition is compiled by hand, so that the page runs no text as code. */
function compile(source){
  const tokens=source.match(/"[^"]*"|[A-Za-z_]\w*|-?\d+(?:\.\d+)?(?:e[-+]?\d+)?|<=|>=|==|!=|&&|\|\||[<>()]/gi)||[];let i=0;
  const value=()=>{const t=tokens[i++];if(t===undefined)throw "the condition ends too early";
    if(t==="("){const v=any();if(tokens[i++]!==")")throw "a bracket is not closed";return v}
    if(t[0]==='"')return()=>t.slice(1,-1);if(/^-?\d/.test(t))return()=>Number(t);
    if(t==="name")return r=>r[0];const k=at(t);if(k<0)throw "there is no column "+t;return r=>r[1][k]};
  const compared=()=>{const a=value(),o=tokens[i];const ops={"<":(x,y)=>x<y,">":(x,y)=>x>y,"<=":(x,y)=>x<=y,">=":(x,y)=>x>=y,"==":(x,y)=>x===y,"!=":(x,y)=>x!==y};
    if(!ops[o])return a;i++;const b=value();return r=>{const x=a(r),y=b(r);return x!==null&&y!==null&&ops[o](x,y)}};
  const all=()=>{let a=compared();while(tokens[i]==="&&"){i++;const l=a,b=compared();a=r=>l(r)&&b(r)}return a};
  const any=()=>{let a=all();while(tokens[i]==="||"){i++;const l=a,b=all();a=r=>l(r)||b(r)}return a};
  const result=any();if(i<tokens.length)throw "not understood: "+tokens[i];return result}
function filtered(){const s=$("filter").value.trim();$("message").textContent="";if(!s)return data.rows;
  if(/[<>=!]/.test(s)){try{return data.rows.filter(compile(s))}catch(e){$("message").textContent=String(e);return data.rows}}
  const w=s.toLowerCase();return data.rows.filter(r=>r[0].toLowerCase().includes(w)||r[1].some(v=>typeof v==="string"&&v.toLowerCase().includes(w)))}
function sorted(rows){if(state.sort<0)return rows;const sign=state.down?-1:1,k=state.sort;
  return [...rows].sort((a,b)=>{const x=a[1][k],y=b[1][k];if(x===null||y===null)return (x===null)-(y===null);return x<y?-sign:x>y?sign:0})}
function outline(path){const svg=element("svg",{viewBox:"-1.1 -1.1 2.2 2.2","aria-hidden":"true"});
  svg.append(element("path",{d:"M"+path+"Z","stroke-width":.06,transform:"scale(1,-1)"}));return svg}
function head(){const row=element("tr");for(const title of ["design","K_SE","K_PE"])row.append(element("th",{scope:"col"},title));
  C.forEach((c,k)=>{const here=state.sort===k,th=element("th",{title:c.meaning,scope:"col","aria-sort":here?(state.down?"descending":"ascending"):"none"});
    const button=element("button",{type:"button"},c.name+(here?(state.down?" \u2193":" \u2191"):""));
    button.onclick=()=>{state.down=here&&!state.down;state.sort=k;update();document.querySelectorAll(".study th button")[k].focus()};th.append(button);row.append(th)});
  document.querySelector(".study thead").replaceChildren(row)}
const report=r=>data.has_reports&&r[1][at("outcome")]==="made"?"designs/"+encodeURIComponent(r[0])+"/report.html":null;
function line(r){const row=element("tr",r===state.picked?{class:"picked"}:{}),first=element("td");
  if(report(r)){first.append(element("a",{href:report(r)},r[0]))}else first.textContent=r[0];
  row.append(first);for(const path of [r[2],r[3]]){const cell=element("td");if(path)cell.append(outline(path));row.append(cell)}
  C.forEach((c,k)=>row.append(element("td",c.text?{}:{class:"num"},text(r[1][k]))));return row}
function table(){head();document.querySelector(".study tbody").replaceChildren(...state.rows.slice(0,state.shown).map(line));
  $("count").textContent=state.rows.length+" of "+data.rows.length+" designs";$("more").hidden=state.rows.length<=state.shown}
function pareto(points){const best=v=>v==="least"?1:-1,sx=best($("bx").value),sy=best($("by").value);let low=Infinity;
  return new Set([...points].sort((a,b)=>sx*(a.x-b.x)||sy*(a.y-b.y)).filter(p=>{const v=sy*p.y;if(v<low){low=v;return true}return false}).map(p=>p.r))}
function ticks(low,high){const raw=(high-low)/5||1,ten=10**Math.floor(Math.log10(raw)),step=[1,2,5,10].map(f=>f*ten).find(s=>s>=raw),all=[];
  for(let t=Math.ceil(low/step)*step;t<=high+1e-9*step;t+=step)all.push(Number(t.toPrecision(6)));return all}
function plot(){const kx=at($("x").value),ky=at($("y").value),W=880,H=460,L=70,B=48;
  const points=state.rows.map(r=>({r,x:r[1][kx],y:r[1][ky]})).filter(p=>typeof p.x==="number"&&typeof p.y==="number");
  const range=k=>{let low=Infinity,high=-Infinity;for(const p of points){low=Math.min(low,p[k]);high=Math.max(high,p[k])}const pad=(high-low||Math.abs(high)||1)*.04;return[low-pad,high+pad]};
  const svg=element("svg",{viewBox:`0 0 ${W} ${H}`,role:"img","aria-label":`${C[ky].name} over ${C[kx].name}; the table below has the values`});
  if(points.length){const [x0,x1]=range("x"),[y0,y1]=range("y"),X=x=>L+(x-x0)/(x1-x0)*(W-L-16),Y=y=>H-B-(y-y0)/(y1-y0)*(H-B-14);
  for(const t of ticks(x0,x1)){svg.append(element("line",{x1:X(t),x2:X(t),y1:14,y2:H-B,class:"rule"}),element("text",{x:X(t),y:H-B+18,"text-anchor":"middle"},t))}
  for(const t of ticks(y0,y1)){svg.append(element("line",{x1:L,x2:W-16,y1:Y(t),y2:Y(t),class:"rule"}),element("text",{x:L-8,y:Y(t)+4,"text-anchor":"end"},t))}
  const front=$("front").checked?pareto(points):new Set();
  for(const p of [...points].sort((a,b)=>front.has(a.r)-front.has(b.r))){const c=element("circle",{cx:X(p.x),cy:Y(p.y),r:front.has(p.r)?5:3.5,
    class:(front.has(p.r)?"front ":"")+(p.r===state.picked?"picked":"")});c.append(element("title",{},`${p.r[0]}\n${C[kx].name} ${text(p.x)}\n${C[ky].name} ${text(p.y)}`));
    if(report(p.r)){const link=element("a",{href:report(p.r),tabindex:-1});link.append(c);svg.append(link);continue}  // keys: the table's links
    c.onclick=()=>{state.picked=p.r;const rest=state.rows.filter(r=>r!==p.r);state.rows=[p.r,...rest];table();plot()};svg.append(c)}}
  svg.append(element("text",{x:(L+W)/2,y:H-8,"text-anchor":"middle",class:"name"},C[kx].name),
    element("text",{transform:`translate(16 ${(H-B)/2}) rotate(-90)`,"text-anchor":"middle",class:"name"},C[ky].name));$("plot").replaceChildren(svg)}
function update(){state.rows=sorted(filtered());table();plot()}
for(const id of ["x","y"]){for(const c of C)if(!c.text)$(id).append(element("option",{title:c.meaning},c.name));}
const first=C.find(c=>c.name.startsWith("dead_band_"));$("x").value=at("mass_g")>=0?"mass_g":C[1].name;if(first)$("y").value=C.filter(c=>c.name.startsWith("dead_band_")&&!c.name.includes("built")&&!c.name.includes("error")).pop().name;
for(const id of ["x","y","bx","by","front"])$(id).onchange=plot;$("filter").oninput=()=>{state.shown=100;update()};$("more").onclick=()=>{state.shown+=500;table()};
update();
)js";
}

}  // namespace fusee::report
