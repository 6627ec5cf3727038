export default function About() {
  return (
    <>
      <h1>About</h1>
      <p>A page without a scene. Whoever comes back finds the blocks falling anew.</p>
    </>
  );
}
