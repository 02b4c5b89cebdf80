// Inside the page, where the figure has begun: a page that is alone has none of the other scripts.
if (window.makeRoom) {
  makeRoom();
  document.fonts.ready.then(makeRoom);
} else {
  const problem = document.getElementById("problem");
  problem.textContent = "This page is of a site, and needs the folder “shared” beside it. gjkscope export NAME --format html makes one file that needs no other.";
  problem.hidden = false;
}
