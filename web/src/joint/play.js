// Runs the co-contraction from its least to its greatest value and back, until it is stopped.

const kRun_ms = 4000;

export function makePlayer(viewer) {
  const { tau: [low, high] } = viewer.poses, player = { on: false };
  const share = (value) => (value - low) / (high - low || 1);
  const show = () => {
    viewer.play.setAttribute("aria-pressed", String(player.on));
    viewer.play.textContent = player.on ? "\u25a0 Stop" : "\u25b6 Play co-contraction";
    viewer.root.dataset.playing = String(player.on);
  };
  player.stop = () => {
    if (!player.on) return;
    player.on = false;
    show();
  };
  player.toggle = () => {
    if (player.on) return player.stop();
    player.on = true;
    show();
    let phase = share(viewer.state.tau), last = null;  // 0 to 1 upwards, 1 to 2 downwards
    const step = (now) => {
      if (!player.on) return;
      phase = (phase + (last === null ? 0 : now - last) / kRun_ms) % 2;
      last = now;
      viewer.setTau(low + (phase > 1 ? 2 - phase : phase) * (high - low));
      requestAnimationFrame(step);
    };
    requestAnimationFrame(step);
  };
  return player;
}
