import type { Metadata } from 'next';
import Link from 'next/link';
import Script from 'next/script';
import type { ReactNode } from 'react';
import './style.css';

export const metadata: Metadata = {
  title: 'Falling blocks, with Next',
  icons: { icon: 'data:,' },
};

export default function Layout({ children }: { children: ReactNode }) {
  return (
    <html lang="en">
      <body>
        {/* A classic script by a tag of its own, see x3dom.js/route.ts; it writes into the page, so React comes first. */}
        <Script src="/x3dom.js" strategy="afterInteractive" />
        <nav>
          <Link href="/">Blocks</Link> <Link href="/about">About</Link>{' '}
          {/* x3dom reads a page once, when it is loaded: a whole page for whoever goes there. */}
          <a href="/served">Served</a>
        </nav>
        {children}
      </body>
    </html>
  );
}
