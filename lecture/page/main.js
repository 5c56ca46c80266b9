// Starts all of it.

speak(language);
$("language").onclick = () => (ask ? act({ language: next() }) : speak(next()));
start().then(() => {
  change({ do: { language } });
  readTours();
  document.documentElement.classList.add("runs");
  indent();
  hands();
  buttons();
  readCode();
  keys();
  open(location.hash);
  enliven();
}).catch((error) => {
  console.warn(error);
  document.documentElement.classList.add("broken");
  $("broken").hidden = false;
});
