// What is shown now, and what is done with it.

/** What the steps' program says of its desk. */
let state = null;

/** Does what a question asks for, and shows what came of it; more may follow if it is `moving`. */
function does(question, moving = false) {
  let done;
  try {
    done = change(question);
  } catch (error) {
    return notice(error.message);
  }
  if (done.said && !done.known) notice(done.said);
  if (!done.known) return done;
  notice(done.said || "");
  if (done.redraw && moving) refreshSoon();
  else if (done.redraw || done.repaint) refresh(!question.do || !question.do.open);
  if (done.redraw) redraw(moving);
  else if (done.repaint) show();
  if (done.glide) glide();
  return done;
}

const act = (what) => does({ do: what });
/** What a hand does, of which more may follow at once. */
const moved = (what) => does({ do: what }, true);

/** Does what a key does. */
function press(key, down = true, fine = false) {
  const done = does({ key: { key, down } });
  if (!done) return true;
  if (done.hand) HANDS[done.hand](fine);
  if (done.save) save();
  if (done.command) copy(asked("command"));
  return done.known;
}

/** Whether another step or another stop is shown. */
const isElsewhere = (before) => before.step !== state.step
  || (before.stop && before.stop.number) !== (state.stop && state.stop.number);

/** While something is dragged, what is beside the picture is anew each so many milliseconds. */
const REFRESH_MS = 100;
/** When that was done last, and the timer of the next time. */
let [refreshed, refreshing] = [0, 0];

function refreshSoon() {
  const wait = Math.max(0, refreshed + REFRESH_MS - performance.now());
  refreshing ||= setTimeout(refresh, wait, true);
}

/** The picture is at rest: so is all beside it. */
function settle() {
  if (refreshing) refresh(true);
  describe();
}

/** Reads what the steps' program holds now, and shows it; another step can be come back from. */
function refresh(keeps) {
  clearTimeout(refreshing);
  refreshing = 0;
  const before = state;
  state = asked({ state: { spoken } });
  if (before && !passing && isCovered() && isElsewhere(before)) uncover();
  const said = languageOf(state.language);
  if (said !== language) speak(said);
  const other = !before || before.step !== state.step || before.language !== state.language;
  if (other || covered !== isCovered()) showStep();
  if (showControls() || other) choose(selected());
  showStage();
  explain();
  showGist();
  showCode();
  showClass();
  showOffers();
  read(before);
  // Another text is read from its top on.
  if (before && before.step !== state.step) scrollTo({ top: 0, behavior: "instant" });
  writeAddress(keeps && before && isElsewhere(before) ? before.address : "");
  refreshed = performance.now();
}
