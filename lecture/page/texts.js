// What is said in words, in the language of the page.

const $ = (id) => document.getElementById(id);

/** Of each language its texts by their English, in the order in which the page goes round. */
const TEXTS = JSON.parse($("texts").textContent);
const LANGUAGES = Object.keys(TEXTS);

/** The language of the page that is meant by `locale`, if there is one. */
const languageOf = (locale) =>
  LANGUAGES.find((known) => known.slice(0, 2) === locale.slice(0, 2).toLowerCase());

/** The one that the browser likes most. */
const spoken = (navigator.languages || []).map(languageOf).find((found) => found) || "en";
let language = spoken;

/** A text in the language of the page, found by its English. */
const text = (english) => TEXTS[language][english] || english;

const next = () => LANGUAGES[(LANGUAGES.indexOf(language) + 1) % LANGUAGES.length];

const two = (step) => String(step).padStart(2, "0");
const handout = (step) => $(`handout${two(step)}-${language}`);

/** Says everything in this language. */
function speak(chosen) {
  language = chosen;
  document.documentElement.lang = language;
  for (const place of document.querySelectorAll("[data-text]"))
    place.textContent = text(place.dataset.text);
  for (const place of document.querySelectorAll("[data-name]"))
    place.setAttribute("aria-label", text(place.dataset.name));
  for (const place of document.querySelectorAll("[data-step]"))
    place.textContent = titleOf(place.dataset.step).split(" · ")[1];
  for (const article of document.querySelectorAll("article[lang]"))
    article.hidden = article.lang !== language;
  const name = new Intl.DisplayNames([next()], { type: "language" }).of(next().slice(0, 2));
  $("language").textContent = name.charAt(0).toUpperCase() + name.slice(1);
  $("language").lang = next();
}

const titleOf = (step) => handout(step).querySelector("h2").textContent;

/** What is said until something else is done. */
function notice(words = "") {
  $("notice").textContent = words;
  $("notice").hidden = !words;
}

function element(name, properties, ...children) {
  const made = Object.assign(document.createElement(name), properties);
  made.append(...children);
  return made;
}

/** What was folded or unfolded by hand. */
const folds = new Map();

/** Something that can be folded, and is open at first or not. */
function foldable(key, open, ...title) {
  const made = element("details", { open: folds.get(key) ?? open });
  const summary = element("summary", {}, ...title);
  summary.onclick = () => folds.set(key, !made.open);
  made.append(summary);
  return made;
}
