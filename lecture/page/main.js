// Starts all of it.

speak(language);
$("language").onclick = () => (ask ? act({ language: next() }) : speak(next()));
// Until something is missing, what stands in for the pictures is not shown.
document.documentElement.classList.add("runs");
start().then(() => {
  change({ do: { language } });
  change({ tours });
  indent();
  hands();
  buttons();
  readCode();
  keys();
  offer();
  $("passage").oninput = pass;
  open(location.hash);
  enliven();
}).catch((error) => {
  console.warn(error);
  document.documentElement.classList.replace("runs", "broken");
  $("broken").hidden = false;
  // The links lead to the texts that are there.
  document.addEventListener("click", (event) => {
    const link = event.target.closest("a[href^='#step']");
    if (!link) return;
    event.preventDefault();
    handout(Number(link.hash.slice(5))).scrollIntoView();
  });
});
