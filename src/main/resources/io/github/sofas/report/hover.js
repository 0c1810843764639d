// Points at one time in all plots at once, and tells it and the values of the curves there.
const left = 56, width = 640, top_ = 8, bottom = 30;
const plots = [...document.querySelectorAll('svg.plot')].map(svg => ({
  svg,
  lines: [...svg.querySelectorAll('path.line')].map(path => ({
    name: path.querySelector('title').textContent,
    style: path.classList[1],
    points: [...path.getAttribute('d').matchAll(/[ML]([\d.]+) ([\d.-]+)/g)].map(p => [+p[1], +p[2]]),
  })),
}));

function element(name, attributes, text) {
  const made = document.createElementNS('http://www.w3.org/2000/svg', name);
  for (const key in attributes) made.setAttribute(key, attributes[key]);
  made.textContent = text || '';
  return made;
}

function nearest(points, x) {
  return points.reduce((best, p) => Math.abs(p[0] - x) < Math.abs(best[0] - x) ? p : best, [-1e9, 0]);
}

function point({svg, lines}, x) {
  const height = svg.viewBox.baseVal.height - bottom;
  const scale = parseFloat(getComputedStyle(svg.querySelector('text')).fontSize);
  const {to, low, high, unit} = svg.dataset;
  const group = element('g', {class: 'pointer'});
  group.append(element('path', {class: 'cursor', d: `M${x} 0V${height}`}));
  const beyond = x > (left + width) / 2;
  const texts = [[((x - left) / (width - left) * to).toFixed(3) + ' s', '']];
  for (const line of lines) {
    const [at, y] = nearest(line.points, x);
    if (Math.abs(at - x) < 4) {
      const value = +low + (height - y) / (height - top_) * (high - low);
      texts.push([`${line.name}: ${value.toPrecision(3) * 1} ${unit}`, line.style]);
    }
  }
  const longest = Math.max(...texts.map(text => text[0].length));
  const w = scale * (0.56 * longest + 0.8);
  const ground = {class: 'ground', x: beyond ? x - w - 4 : x + 4, y: 0, width: w, height: scale * 1.2 * texts.length + 4};
  group.append(element('rect', ground));
  texts.forEach(([text, style], i) => group.append(element('text',
    {x: ground.x + scale * 0.4, y: scale * (1.2 * i + 1), class: 'said ' + style}, text)));
  svg.querySelector('.pointer')?.remove();
  svg.append(group);
}

for (const {svg} of plots) {
  svg.addEventListener('pointermove', event => {
    const box = svg.getBoundingClientRect();
    const x = Math.min(width, Math.max(left, (event.clientX - box.left) / box.width * width));
    plots.forEach(plot => point(plot, x));
  });
  svg.addEventListener('pointerleave', () => document.querySelectorAll('.pointer').forEach(each => each.remove()));
}
