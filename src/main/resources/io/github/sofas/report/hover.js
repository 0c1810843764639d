// Points at one time in all plots at once, and says which.
const plots = [...document.querySelectorAll('svg.plot')];
const left = 56, width = 640;
for (const plot of plots) {
  plot.addEventListener('pointermove', event => {
    const box = plot.getBoundingClientRect();
    const x = Math.max(left, (event.clientX - box.left) / box.width * width);
    for (const each of plots) {
      let group = each.querySelector('.pointer');
      if (!group) {
        group = document.createElementNS('http://www.w3.org/2000/svg', 'g');
        group.setAttribute('class', 'pointer');
        each.appendChild(group);
      }
      const height = each.viewBox.baseVal.height - 30;
      const s = (x - left) / (width - left) * each.dataset.to;
      group.innerHTML = `<path class="cursor" d="M${x} 0V${height}"/>`
        + `<text x="${x > 560 ? x - 4 : x + 4}" y="12" class="${x > 560 ? 'end' : ''}">${s.toFixed(3)} s</text>`;
    }
  });
}
