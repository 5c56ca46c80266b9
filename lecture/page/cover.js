// The cover: all steps in one picture, until one of them is opened.

const isCovered = () => document.body.classList.contains("covered");

/** What the cover leads to is not what the reader went to. */
let passing = false;

/** Shows the steps so far along: at 6.3 three tenths of step 07, and the rest of step 06. */
function pass() {
  const along = Number($("passage").value);
  const step = Math.max(1, Math.ceil(along));
  passing = true;
  if (state.step !== step) act({ step });
  if (step > 1) moved({ divideAt: step - along });
  passing = false;
  showPassage();
}

/** Says which question is being answered. */
function showPassage() {
  const question = handout(state.step).querySelector(".question").textContent;
  $("passed").textContent = `${two(state.step)} · ${question}`;
  $("passed").lang = language;
  $("passage").setAttribute("aria-valuetext", $("passed").textContent);
  for (const link of document.querySelectorAll(".cover li a"))
    link.classList.toggle("passed", link.hash === `#step${two(state.step)}`);
}

/** A step is opened: there is no cover any more, nor its divider. */
function uncover() {
  document.body.classList.remove("covered");
  if (state.divider === null) return;
  change({ key: { key: "d", down: true } });
  state = asked({ state: { spoken } });
}
