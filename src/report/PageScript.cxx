/*=========================================================================
 *
 *  Copyright NumFOCUS
 *
 *  Licensed under the Apache License, Version 2.0 (the "License");
 *  you may not use this file except in compliance with the License.
 *  You may obtain a copy of the License at
 *
 *         https://www.apache.org/licenses/LICENSE-2.0.txt
 *
 *  Unless required by applicable law or agreed to in writing, software
 *  distributed under the License is distributed on an "AS IS" BASIS,
 *  WITHOUT WARRANTIES OR CONDITIONS OF ANY KIND, either express or implied.
 *  See the License for the specific language governing permissions and
 *  limitations under the License.
 *
 *=========================================================================*/
#include "report/PageSections.h"

namespace mmm
{
const char * const PageScript = R"js('use strict';
for (const element of document.querySelectorAll('.tools, .layers, .legend input, .save')) {
  element.hidden = false;
}
for (const box of document.querySelectorAll('[data-layer]')) {
  box.addEventListener('change', () =>
    document.getElementById('cuts').classList.toggle('no-' + box.dataset.layer, !box.checked));
}
for (const box of document.querySelectorAll('[data-show]')) {
  box.addEventListener('change', () => {
    for (const path of document.querySelectorAll('[data-label="' + box.dataset.show + '"]')) {
      path.classList.toggle('off', !box.checked);
    }
  });
}
const report = document.getElementById('report').textContent;
document.getElementById('save').addEventListener('click', event => {
  event.currentTarget.href = URL.createObjectURL(new Blob([report], { type: 'application/json' }));
});

const mostZoom = 200;
for (const figure of document.querySelectorAll('.cut')) {
  const svg = figure.querySelector('.frame svg');
  const whole = svg.getAttribute('viewBox').split(' ').map(Number);
  let [x, y, width, height] = whole;
  const show = () => {
    x = Math.min(Math.max(x, 0), whole[2] - width);
    y = Math.min(Math.max(y, 0), whole[3] - height);
    svg.setAttribute('viewBox', [x, y, width, height].join(' '));
  };
  // by a factor, around a place in the picture, in [0, 1]
  const zoom = (factor, u = 0.5, v = 0.5) => {
    const next = Math.min(Math.max(width * factor, whole[2] / mostZoom), whole[2]);
    const nextHeight = next * whole[3] / whole[2];
    x += u * (width - next);
    y += v * (height - nextHeight);
    [width, height] = [next, nextHeight];
    show();
  };
  const move = (right, down) => {
    x += right * width;
    y += down * height;
    show();
  };
  const actions = {
    in: () => zoom(1 / 1.5),
    out: () => zoom(1.5),
    whole: () => zoom(Infinity),
    large: () => figure.classList.toggle('large')
  };
  for (const button of figure.querySelectorAll('[data-do]')) {
    button.addEventListener('click', actions[button.dataset.do]);
  }
  svg.addEventListener('wheel', event => {
    if (document.activeElement === svg || event.ctrlKey) {
      event.preventDefault();
      const frame = svg.getBoundingClientRect();
      zoom(Math.exp(event.deltaY * (event.deltaMode === 1 ? 0.03 : 0.0015)),
        (event.clientX - frame.left) / frame.width, (event.clientY - frame.top) / frame.height);
    }
  }, { passive: false });
  svg.addEventListener('pointerdown', event => {
    if (event.button === 0) {
      svg.focus({ preventScroll: true });
      svg.setPointerCapture(event.pointerId);
    }
  });
  svg.addEventListener('pointermove', event => {
    if (svg.hasPointerCapture(event.pointerId)) {
      move(-event.movementX / svg.clientWidth, -event.movementY / svg.clientHeight);
    }
  });
  const keys = {
    '+': actions.in, '=': actions.in, '-': actions.out, '0': actions.whole,
    ArrowLeft: () => move(-0.1, 0), ArrowRight: () => move(0.1, 0),
    ArrowUp: () => move(0, -0.1), ArrowDown: () => move(0, 0.1)
  };
  svg.addEventListener('keydown', event => {
    if (keys[event.key]) {
      event.preventDefault();
      keys[event.key]();
    }
  });
}
)js";
} // namespace mmm
